#!/usr/bin/env python3
"""Checks the sources of core, ui and app against the tables beside this file: arrows.txt says who may include whom,
banned.txt what is never called. Also that includes make no ring and are written from the project's folder.

    check.py [FOLDER]     the project's folder

One line for each fault; exit code 1 if there is one."""
import fnmatch
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).parent
SHEETS = ("elevation", "subdivision", "spline", "combined")
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)
# Literals and comments; raw strings first, so that a quote inside ends nothing.
SKIPPED = re.compile(r"""R"([^(\s]*)\(.*?\)\1" | "(?:\\.|[^"\\\n])*" | '(?:\\[^'\n]+|\\'|[^'\\\n])'
                         | //[^\n]* | /\*.*?\*/""", re.DOTALL | re.VERBOSE)


def table(text):
    """The lines that say something, without comments."""
    return [line for line in text.splitlines() if line.strip() and not line.startswith("#")]


def fits(path, pattern):
    """Whether the pattern names the file or a folder above it."""
    return fnmatch.fnmatchcase(path, pattern) or fnmatch.fnmatchcase(path, pattern + "/*")


class Arrow:
    """One line of arrows.txt for one sheet; `sheet` is None in a line that names none."""

    def __init__(self, left, right, sheet):
        self.left = left.replace("<sheet>", sheet or "")
        self.allowed, self.refused = [], []
        for word in right.replace("<sheet>", sheet or "").split():
            names = [word]
            if "<other>" in word:
                names = [word.replace("<other>", other) for other in SHEETS if other != sheet]
            for name in names:
                (self.refused if name.startswith("-") else self.allowed).append(name.removeprefix("-"))

    def allows(self, path, included):
        if pathlib.PurePath(included).parent == pathlib.PurePath(path).parent:
            return True
        return any(fits(included, x) for x in self.allowed) and not any(fits(included, x) for x in self.refused)


def arrows(text):
    found = []
    for line in table(text):
        left, right = (part.strip() for part in line.split(":"))
        for sheet in SHEETS if "<sheet>" in left else (None,):
            found.append(Arrow(left, right, sheet))
    return found


def include_faults(files, rules):
    """`files` maps the path of each source to its text."""
    for path, text in files.items():
        rule = next((rule for rule in rules if fits(path, rule.left)), None)
        if rule is None:
            yield f"{path}: no line of arrows.txt fits its folder"
            continue
        for bracket, included in INCLUDE.findall(text):
            if bracket == "<":
                if path.startswith("core/") and re.match("[Qq]", included):
                    yield f"{path}: includes <{included}>, and core knows no Qt"
            elif included.endswith(".moc"):
                continue
            elif included not in files:
                yield f'{path}: includes "{included}", which is no file counted from the project\'s folder'
            elif not rule.allows(path, included):
                yield f"{path}: includes {included}, against arrows.txt"


def ring_faults(files):
    """Headers that include each other in a ring; #pragma once would hide it until a type is missing."""
    graph = {path: [name for bracket, name in INCLUDE.findall(text) if bracket == '"' and name in files]
             for path, text in files.items()}
    done, way = set(), []

    def visit(path):
        if path in way:
            yield "ring of includes: " + " -> ".join(way[way.index(path):] + [path])
        elif path not in done:
            way.append(path)
            for included in graph[path]:
                yield from visit(included)
            way.pop()
            done.add(path)

    for path in graph:
        yield from visit(path)


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
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else HERE.parent.parent
    files = sources(root)
    faults = [*include_faults(files, arrows((HERE / "arrows.txt").read_text(encoding="utf-8"))), *ring_faults(files),
              *banned_faults(files, (HERE / "banned.txt").read_text(encoding="utf-8"))]
    print(*faults, f"{len(files)} sources, {len(faults)} faults", sep="\n")
    return 0 if files and not faults else 1


if __name__ == "__main__":
    sys.exit(main())
