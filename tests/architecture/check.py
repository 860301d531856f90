#!/usr/bin/env python3
"""Checks the sources of core, ui and app against the tables beside this file: floors.txt says who may include whom,
banned.txt what is never called. Also that neither files nor the folders of a room include each other in a ring, and
that includes are written from the project's folder.

    check.py [FOLDER]            the project's folder; one line for each fault, exit code 1 if there is one
    check.py --rooms [FOLDER]    what each room includes, and how many rooms, arrows and rings there are; exit code 1
                                 if there is a ring of folders"""
import argparse
import fnmatch
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).parent
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)
# Literals and comments; raw strings first, so that a quote inside ends nothing.
SKIPPED = re.compile(r"""R"([^(\s]*)\(.*?\)\1" | "(?:\\.|[^"\\\n])*" | '(?:\\[^'\n]+|\\'|[^'\\\n])'
                         | //[^\n]* | /\*.*?\*/""", re.DOTALL | re.VERBOSE)


def table(text):
    """The lines that say something, without comments."""
    return [line for line in text.splitlines() if line.strip() and not line.startswith("#")]


def floors(text):
    """The height of each room above the ground."""
    return {room: height for height, line in enumerate(reversed(table(text))) for room in line.split()}


def room_of(path, heights):
    for room in heights:
        if not room.endswith("/") and path.startswith(room + "/"):
            return room
        folder = path[len(room):].split("/")[:-1]
        if room.endswith("/") and path.startswith(room) and folder:
            return room + folder[0]
    return None


def line_of(room, heights):
    """The name in the list that stands for a room."""
    return room if room in heights else folder_of(room) + "/"


def height_of(room, heights):
    return heights[line_of(room, heights)]


def each_height(files, heights):
    """The height of each room by its own name, those too that a line with a slash stands for."""
    rooms = sorted({room_of(path, heights) for path in files} - {None})
    return {room: height for line, height in heights.items()
            for room in ([line] if line in rooms else [room for room in rooms if line_of(room, heights) == line])}


def folder_of(path):
    return str(pathlib.PurePath(path).parent)


def quoted_includes(text):
    return [name for bracket, name in INCLUDE.findall(text) if bracket == '"' and not name.endswith(".moc")]


def room_faults(files, heights):
    """`files` maps the path of each source to its text."""
    for path in files:
        if room_of(path, heights) is None:
            yield f"{path}: stands in no room of floors.txt"
    for room in heights:
        if not any(path.startswith(room.rstrip("/") + "/") for path in files):
            yield f"floors.txt: {room} is no folder with sources"


def include_faults(files, heights):
    for path, text in files.items():
        room = room_of(path, heights)
        if path.startswith("core/"):
            for bracket, included in INCLUDE.findall(text):
                if bracket == "<" and re.match("[Qq]", included):
                    yield f"{path}: includes <{included}>, and core knows no Qt"
        for included in quoted_includes(text):
            other = room_of(included, heights)
            if included not in files:
                yield f'{path}: includes "{included}", which is no file counted from the project\'s folder'
            elif room and other and other != room and height_of(other, heights) >= height_of(room, heights):
                where = "above" if height_of(other, heights) > height_of(room, heights) else "beside"
                yield f"{path}: includes {included}, and {other} stands {where} {room}"


def rings(graph):
    """`graph` maps each node to those that it leads to. Every ring is found once."""
    done, way = set(), []

    def visit(node):
        if node in way:
            yield " -> ".join(way[way.index(node):] + [node])
        elif node not in done:
            way.append(node)
            for following in graph[node]:
                yield from visit(following)
            way.pop()
            done.add(node)

    for node in graph:
        yield from visit(node)


def ring_faults(files, heights):
    """Headers that include each other in a ring, which #pragma once would hide until a type is missing, and folders of
    one room that do. The folder that a room's subfolders stand in counts like they do."""
    headers = {path: [name for name in quoted_includes(text) if name in files] for path, text in files.items()}
    folders = {folder_of(path): [] for path in files}
    for path, names in headers.items():
        for name in names:
            if folder_of(name) != folder_of(path) and room_of(name, heights) == room_of(path, heights):
                folders[folder_of(path)].append(folder_of(name))
    for kind, graph in (("includes", headers), ("folders", folders)):
        for ring in rings(graph):
            yield f"ring of {kind}: {ring}"


def arrows(files, places):
    """Which places include which others; `places` gives that of a path, or nothing."""
    graph = {place: set() for place in map(places, files) if place}
    for path, text in files.items():
        for name in quoted_includes(text):
            start, end = places(path), places(name)
            if name in files and start and end and start != end:
                graph[start].add(end)
    return {place: sorted(graph[place]) for place in graph}


def room_lines(files, heights):
    """The house in words, and its rings."""
    rooms = arrows(files, lambda path: room_of(path, heights))
    heights = each_height(files, heights)
    for room in sorted(rooms, key=lambda room: (-heights[room], list(heights).index(room))):
        below = sorted(rooms[room], key=lambda other: -heights[other])
        yield f"{room} -> {', '.join(below) or 'nothing'}"
    folders = arrows(files, folder_of)
    found = list(rings(folders))
    yield from (f"ring: {ring}" for ring in found)
    for kind, graph in (("rooms", rooms), ("folders", folders)):
        yield f"{len(graph)} {kind}, {sum(map(len, graph.values()))} arrows between them"
    yield f"{len(found)} rings"


def fits(path, pattern):
    """Whether the pattern names the file or a folder above it."""
    return fnmatch.fnmatchcase(path, pattern) or fnmatch.fnmatchcase(path, pattern + "/*")


def code_alone(text):
    """The same lines, literals and comments blanked."""
    return SKIPPED.sub(lambda match: "\n" * match.group().count("\n"), text)


def banned_faults(files, text):
    rules = []
    for line in table(text):
        pattern, allowed, why = (part.strip() for part in line.rsplit(" | ", 2))
        rules.append((re.compile(pattern), allowed, why))
    for path, source in files.items():
        for number, line in enumerate(code_alone(source).splitlines(), 1):
            for pattern, allowed, why in rules:
                found = pattern.search(line)
                if found and not fits(path, allowed):
                    yield f"{path}:{number}: {found.group()}: {why}"


def sources(root):
    return {str(path.relative_to(root)): path.read_text(encoding="utf-8")
            for folder in ("core", "ui", "app") for path in sorted((root / folder).rglob("*"))
            if path.suffix in (".h", ".cpp")}


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    options.add_argument("--rooms", action="store_true", help="tell what each room includes")
    options.add_argument("folder", nargs="?", type=pathlib.Path, default=HERE.parent.parent)
    given = options.parse_args()
    files, heights = sources(given.folder), floors((HERE / "floors.txt").read_text(encoding="utf-8"))
    if given.rooms:
        lines = list(room_lines(files, heights))
        print(*lines, sep="\n")
        return 0 if files and lines[-1] == "0 rings" else 1
    faults = [*room_faults(files, heights), *include_faults(files, heights), *ring_faults(files, heights),
              *banned_faults(files, (HERE / "banned.txt").read_text(encoding="utf-8"))]
    print(*faults, f"{len(files)} sources, {len(faults)} faults", sep="\n")
    return 0 if files and not faults else 1


if __name__ == "__main__":
    sys.exit(main())
