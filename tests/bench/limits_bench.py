#!/usr/bin/env python3
"""Runs Kriva's command line over documents and files at the limits and tells what each took.

    limits_bench.py BUILD-FOLDER [PART-OF-A-NAME...]

Every run is a process of its own, whose CPU time and peak of memory the system counts. An answer may be a refusal (code
3), as long as it comes in time. The inputs are the same in every run of this program."""
import json
import math
import os
import pathlib
import random
import resource
import subprocess
import sys
import tempfile

MOST_SECONDS = 5  # of CPU
MOST_MEMORY = 1 << 30  # bytes
ENOUGH_SECONDS = 20  # what takes longer is ended, and tells nothing more
ENOUGH_MEMORY = 12 << 30

DENSE = (",", ":")


def document(**sheets):
    """A document of one line, by sheet the list of curves."""
    return json.dumps({"format": "kriva", "version": 1,
                       "sheets": {name: {"curves": curves} for name, curves in sheets.items()}},
                      separators=DENSE, ensure_ascii=False)


def randoms(count, seed=1, low=0.0, high=100.0):
    numbers = random.Random(seed)
    return [[round(numbers.uniform(low, high), 6), round(numbers.uniform(low, high), 6)] for _ in range(count)]


def wave(count, turns=50):
    """Points that go right and up and down: one run of a combined curve for each half turn."""
    return [[round(i * 100 / count, 6), round(10 * math.sin(turns * 2 * math.pi * i / count), 6)] for i in range(count)]


def zigzag(count):
    """Points that turn round at each step: a run of a combined curve for each."""
    return [[i % 2, i] for i in range(count)]


def knots(points, **more):
    return {"knots": [{"at": p} for p in points], **more}


def circle(count, radius=10.0, turn=0.0):
    angles = [turn + 2 * math.pi * i / count for i in range(count)]
    return [[round(radius * math.cos(a), 9), round(radius * math.sin(a), 9)] for a in angles]


def line(start, end):
    return knots([start, end])


def cubic(shift=0.0):
    return {"knots": [{"at": [0, 0], "join": "corner", "out": [1 + shift, 2]},
                      {"at": [4, 0], "join": "corner", "in": [3, 2]}]}


def star(count):
    """Lines through one point, whose ends are not each other's mirror images to the last bit."""
    return [line([round(math.cos(a), 9), round(math.sin(a), 9)], [round(-math.cos(a), 9), round(-math.sin(a), 9)])
            for a in (math.pi * i / count for i in range(count))]


def rays(count):
    return [line([0, 0], p) for p in circle(count)]


def fan(count):
    """Lines from one point to a wall, each over all others' way back."""
    return [knots([[0, 0], [10, i / count], [0, 1]]) for i in range(count)]


def rosette(count):
    """A natural chain from the circle to its centre and on to the circle."""
    points = []
    for p in circle(count):
        points += [p, [0, 0]]
    return [knots(points, rule="natural")]


def elevation(points, times):
    return {"points": points, "times": times}


def subdivision(points, levels, **more):
    return {"points": points, "t": 0.5, "levels": levels, **more}


def combined(points, **more):
    return {"points": points, **more}


def parts(points, size):
    return [points[i:i + size] for i in range(0, len(points), size)]


def deep(count):
    return "[" * count + "]" * count


def broad(size):
    """JSON of one list of zeros, of so many bytes."""
    return "[" + "0," * (size // 2 - 2) + "0]"


def svg(inside, head=""):
    return f'<svg xmlns="http://www.w3.org/2000/svg" {head}viewBox="0 0 100 100">{inside}</svg>'


def use_chain(length):
    links = "".join(f'<g id="g{i}"><use href="#g{i - 1}"/><use href="#g{i - 1}"/></g>' for i in range(1, length))
    return svg(f'<defs><g id="g0"><path d="M0 0L1 1"/></g>{links}</defs><use href="#g{length - 1}"/>')


def path(data):
    return svg(f'<path d="{data}"/>')


MEBIBYTE = 1 << 20
TABLE = 60 * MEBIBYTE
FULL = 64 * MEBIBYTE


def documents():
    """Name and text of the documents, each of which is reported and drawn."""
    million = 1_000_000
    yield "elevation: 201 points, 9,900 times", lambda: document(elevation=[elevation(randoms(201), 9900)])
    yield "elevation: 201 points, 10,000 times", lambda: document(elevation=[elevation(randoms(201), 10000)])
    yield "elevation: 2,000,000 elevated points", lambda: document(
        elevation=[elevation(randoms(100, i), 9899) for i in range(200)])
    yield "elevation: 1,000 curves of 201 points", lambda: document(
        elevation=[elevation(randoms(201, i), 0) for i in range(1000)])
    yield "elevation: 1,000 curves, 1,000 times", lambda: document(
        elevation=[elevation(randoms(201, i), 1700) for i in range(1000)])
    yield "subdivision: 2^16 pieces", lambda: document(subdivision=[subdivision(randoms(4), 16)])
    yield "subdivision: 2^16 pieces of degree 29", lambda: document(subdivision=[subdivision(randoms(30), 16)])
    yield "subdivision: 201 points, 2^13 pieces", lambda: document(subdivision=[subdivision(randoms(201), 13)])
    yield "subdivision: 4 points with multiplicity 50", lambda: document(
        subdivision=[subdivision(randoms(4), 13, multiplicity=[50] * 4)])
    yield "subdivision: 1,000 curves, 2,000,000 points of pieces", lambda: document(
        subdivision=[subdivision(randoms(15, i), 7) for i in range(1000)])
    yield "subdivision: 1,000 blossoms of degree 200", lambda: document(
        subdivision=[subdivision(randoms(201, i), 0, blossom=[0.3] * 200) for i in range(1000)])
    for method in "approximation", "interpolation", "pairs":
        yield f"combined: 100,000 points, {method}", lambda: document(
            combined=[combined(randoms(100_000), method=method)])
    for basis in "power", "newton", "lagrange", "chebyshev":
        yield f"combined: 1,000,000 points, approximation of degree 9, {basis}", lambda: document(
            combined=[combined(p, degree=9, basis=basis) for p in parts(randoms(million), 100_000)])
        yield f"combined: 1,000 interpolations of 200 points, {basis}", lambda: document(
            combined=[combined(wave(200, 3), method="interpolation", basis=basis) if i % 2 else
                      combined(sorted(randoms(200, i)), method="interpolation", basis=basis) for i in range(1000)])
    yield "combined: 1,000,000 points in long runs", lambda: document(
        combined=[combined(wave(100_000, 2)) for _ in range(10)])
    yield "combined: 1,000,000 points of pairs in long runs", lambda: document(
        combined=[combined(wave(100_000, 2), method="pairs") for _ in range(10)])
    yield "combined: 1,000,000 points of pairs", lambda: document(
        combined=[combined(p, method="pairs") for p in parts(randoms(million), 100_000)])
    yield "combined: 1,000,000 points, interpolation", lambda: document(
        combined=[combined(p, method="interpolation") for p in parts(randoms(million), 100_000)])
    yield "combined: 1,000,000 points in runs of two", lambda: document(
        combined=[combined(zigzag(100_000)) for _ in range(10)])
    yield "combined: 1,000 curves of 1,000 points", lambda: document(
        combined=[combined(randoms(1000, i)) for i in range(1000)])
    yield "spline: 100,000 knots", lambda: document(spline=[knots(randoms(100_000))])
    yield "spline: 20,000 segments at random", lambda: document(spline=[knots(randoms(20_001))])
    yield "spline: 20,000 segments along a wave", lambda: document(spline=[knots(wave(20_001), rule="natural")])
    yield "spline: 20,000 segments of degree 5", lambda: document(spline=[knots(wave(20_001), degree=5)])
    yield "spline: 20,000 segments, catmull-rom", lambda: document(
        spline=[knots(wave(20_001), rule="catmull-rom")])
    yield "spline: 20,000 segments of degree 2", lambda: document(spline=[knots(wave(20_001), degree=2)])
    yield "spline: 1,000,000 knots", lambda: document(spline=[knots(p) for p in parts(wave(million), 100_000)])
    yield "spline: 2,000 knots at random", lambda: document(spline=[knots(randoms(2000))])
    yield "spline: 1,000 curves of 4 knots at random", lambda: document(
        spline=[knots(p) for p in parts(randoms(4000), 4)])
    yield "spline: 1,000 curves of 20 segments, apart", lambda: document(
        spline=[knots([[x, y + 30 * i] for x, y in wave(21, 2)]) for i in range(1000)])
    yield "spline: 20,001 knots on a line", lambda: document(spline=[knots([[i, 0] for i in range(20_001)])])
    yield "spline: 20,001 knots in one place", lambda: document(spline=[knots([[1, 1]] * 20_001)])
    for count in 100, 400, 1000:
        yield f"spline: star of {count} lines", lambda: document(spline=star(count))
        yield f"spline: {count} rays", lambda: document(spline=rays(count))
        yield f"spline: {count} copies of a line", lambda: document(spline=[line([0, 0], [4, 1])] * count)
        yield f"spline: {count} copies of a cubic", lambda: document(spline=[cubic()] * count)
        yield f"spline: {count} cubics, one derivative 1e-9 apart", lambda: document(
            spline=[cubic(i * 1e-9) for i in range(count)])
        yield f"spline: rosette of {count} leaves", lambda: document(spline=rosette(count))
    yield "spline: fan of 1,000", lambda: document(spline=fan(1000))
    yield "spline: 1,000 curves nearly equal", lambda: document(
        spline=[knots([[x + 1e-7 * i, y] for x, y in randoms(20)]) for i in range(1000)])
    yield "spline: 1,000 closed rings", lambda: document(
        spline=[knots(circle(8, 10, i * 1e-3), closed=True, rule="natural") for i in range(1000)])
    yield "spline: closed chain of 20,000 knots", lambda: document(
        spline=[knots(circle(20_000), closed=True, rule="natural")])


def readings():
    """Name and text of documents whose reading is what matters: they are reported alone."""
    yield "a title of 60 MB", lambda: json.dumps({"format": "kriva", "version": 1, "title": "n" * TABLE})
    yield "1,000 names of 60,000 letters", lambda: document(
        elevation=[{"name": "\u0431" * 30_000, "points": [[0, 0], [1, 1]]} for _ in range(1000)])
    yield "64 MiB of brackets", lambda: deep(FULL // 2)
    yield "64 MiB of zeros in a list", lambda: broad(FULL)
    yield "64 MiB of empty lists", lambda: "[" + "[]," * (FULL // 3 - 2) + "[]]"
    yield "64 MiB of keys", lambda: "{" + ",".join(f'"{i}":0' for i in range(5_200_000)) + "}"
    yield "64 MiB of one key again and again", lambda: '{"format":"kriva"' + ',"k":0' * (FULL // 6 - 4) + "}"
    yield "64 MiB of blanks", lambda: " " * FULL
    yield "64 MiB of line ends that end nothing", lambda: '{"format":"kriva"' + "\n" * (FULL - 17)
    yield "64 MiB of digits", lambda: "1" * FULL
    yield "64 MiB of escapes in a title", lambda: '{"format":"kriva","version":1,"title":"' + "\\u0041" * (
        FULL // 6 - 10) + '"}'
    yield "64 MiB of points in a curve", lambda: '{"format":"kriva","version":1,"sheets":{"combined":{"curves":[' \
        '{"points":[' + "[0,0]," * (FULL // 6 - 30) + "[0,0]]}]}}}"
    yield "64 MiB of curves", lambda: '{"format":"kriva","version":1,"sheets":{"combined":{"curves":[' + "{}," * (
        FULL // 3 - 40) + "{}]}}}"
    yield "64 MiB and a byte", lambda: " " * (FULL + 1)


def imports():
    """Name and text of SVG files, path data and tables, each of which is imported."""
    yield "SVG: 1,000,000 elements", lambda: svg("<g/>" * 999_999)
    yield "SVG: 1,000 paths", lambda: svg('<path d="M0 0L1 2"/>' * 1000)
    yield "SVG: 900,000 paths", lambda: svg('<path d="M0 0L1 2"/>' * 900_000)
    yield "SVG: 1,000,000 rectangles with an id", lambda: svg(
        "".join(f'<rect id="r{i}" width="1" height="1"/>' for i in range(999_999)))
    yield "SVG: 1,000 attributes in a tag", lambda: svg(
        "<g " + " ".join(f'a{i}="1"' for i in range(1000)) + '/><path d="M0 0L1 2"/>')
    yield "SVG: 1,000 tags of 1,000 attributes", lambda: svg(
        ("<g " + " ".join(f'a{i}="1"' for i in range(1000)) + "/>") * 5000 + '<path d="M0 0L1 2"/>')
    yield "SVG: 200,000 attributes in a tag", lambda: svg(
        "<g " + " ".join(f'a{i}="1"' for i in range(200_000)) + "/>")
    yield "SVG: a chain of uses, 15 long", lambda: use_chain(15)
    yield "SVG: a chain of uses, 40 long", lambda: use_chain(40)
    yield "SVG: 100,000 uses of 9 lines", lambda: svg(
        '<defs><path id="p" d="M0 0' + "L1 2L3 4" * 4 + '"/></defs>' + '<use href="#p"/>' * 100_000)
    yield "SVG: nested 256 deep", lambda: svg("<g>" * 255 + '<path d="M0 0L1 1"/>' + "</g>" * 255)
    yield "SVG: nested 1,000,000 deep", lambda: svg("<g>" * 1_000_000 + "</g>" * 1_000_000)
    yield "SVG: a path of 99,998 segments", lambda: path("M0 0" + "L1 2L2 1" * 49_999)
    yield "SVG: a path of 999,998 segments", lambda: path("M0 0" + "L1 2L2 1" * 499_999)
    yield "SVG: 60 MB of path data", lambda: path("M0 0" + "L1 2L2 1" * (TABLE // 8))
    yield "SVG: 60 MB of moves", lambda: path("M0 0" + "M1 2" * (TABLE // 4))
    yield "SVG: 60 MB of closings", lambda: path("M0 0L1 1" + "Z" * TABLE)
    yield "SVG: 60 MB of arcs", lambda: path("M0 0" + "A5 3 20 1 1 9 9A5 3 20 1 1 0 0" * (TABLE // 30))
    yield "SVG: 60 MB of digits", lambda: path("M0 " + "1" * TABLE)
    yield "SVG: 60 MB of zeros before a digit", lambda: path("M0 0." + "0" * TABLE + "1")
    yield "SVG: 60 MB of points in a polygon", lambda: svg('<polygon points="' + "1,2 3,4 " * (TABLE // 8) + '"/>')
    yield "SVG: 60 MB of transforms", lambda: svg(
        '<path d="M0 0L1 1" transform="' + "scale(1)" * (TABLE // 8) + '"/>')
    yield "SVG: a style of 60 MB", lambda: svg('<path d="M0 0L1 1" style="' + "a:b;" * (TABLE // 4) + '"/>')
    yield "SVG: a comment of 60 MB", lambda: svg("<!--" + "-" * TABLE + '--><path d="M0 0L1 1"/>')
    yield "SVG: 60 MB of comments that do not end", lambda: svg("<!--" * (TABLE // 4))
    yield "SVG: 60 MB of references to characters", lambda: svg(
        "<text>" + "&#65;" * (TABLE // 5) + '</text><path d="M0 0L1 1"/>')
    yield "SVG: 60 MB of tags that do not end", lambda: "<" * TABLE
    yield "SVG: a declaration of 60 MB", lambda: "<?" + "x" * TABLE
    yield "path data: 1,000,000 cubics", lambda: "M0 0" + "c1 2 3 4 5 6" * 999_999
    yield "path data: 100,000 subpaths", lambda: "M0 0L1 1" * 100_000
    yield "path data: 60 MB that breaks off", lambda: "M0 0" + "L1 2" * 100_000 + " " * TABLE + "x"
    yield "table: 60 MB in one line", lambda: "1 " * (TABLE // 2)
    yield "table: 60 MB of semicolons", lambda: ";" * TABLE
    yield "table: 60 MB of line ends", lambda: "\n" * TABLE
    yield "table: 60 MB of commas", lambda: "," * TABLE
    yield "table: 60 MB of blanks", lambda: " " * TABLE
    yield "table: 60 MB of bytes that are no text", lambda: b"\x80" * TABLE
    yield "table: 60 MB of blanks of Unicode", lambda: "\u2003" * (TABLE // 3)
    yield "table: 64 MiB of digits", lambda: "1" * FULL
    yield "table: 64 MiB of zeros before a digit", lambda: "0." + "0" * (FULL - 10) + "1 2"
    yield "table: 60 MB of headings", lambda: "a," * (TABLE // 2) + "b\n1,2\n"
    yield "table: a heading of 60 MB", lambda: "x," + "y" * TABLE + "\n1,2\n"
    yield "table: 99,999 rows", lambda: "1 2\n" * 99_999
    yield "table: 1,000,000 short rows", lambda: "1 2\n" * 1_000_000
    yield "table: 1,000,001 short rows", lambda: "1 2\n" * 1_000_001
    yield "table: 1,000,000 rows with commas", lambda: "1.5,2.5\n" * 1_000_000
    yield "table: 60 MB of short rows", lambda: "1 2\n" * (TABLE // 4)
    yield "table: 60 MB of rows with a fault at the end", lambda: "1 2\n" * 100 + "\n" * TABLE + "1 x"
    yield "table: 1,000 curves of 1,000 points", lambda: "curve,point,x,y\n" + "".join(
        f"{c},{p},{p},{c}\n" for c in range(1000) for p in range(1000))
    yield "table: 1,000,000 curves of a point", lambda: "curve,point,x,y\n" + "".join(
        f"{c},0,1,2\n" for c in range(1_000_000))


def runs():
    """Name, text and the command with its options; OUT is replaced by a file to write."""
    formats = {"pdf", "png", "tex"}
    drawn_in_all = ("elevation: 2,000,000", "subdivision: 2^16 pieces of", "combined: 1,000,000 points of pairs",
                    "spline: 1,000,000 knots", "spline: 20,000 segments at")
    for name, text in documents():
        yield f"{name}: report", text, ["report", "--format", "json"], "kriva"
        yield f"{name}: export svg", text, ["export", "-o", "OUT.svg"], "kriva"
        if name.startswith(drawn_in_all):
            yield f"{name}: report as text", text, ["report"], "kriva"
            for ending in sorted(formats):
                yield f"{name}: export {ending}", text, ["export", "-o", f"OUT.{ending}"], "kriva"
            yield f"{name}: export csv", text, ["export", "-o", "OUT.csv"], "kriva"
    yield ("elevation: png of nearly 16,384 pixels a side", lambda: document(elevation=[elevation(randoms(20), 5)]),
           ["export", "-o", "OUT.png", "--dpi", "2370", "--width", "170mm"], "kriva")
    for name, text in readings():
        yield f"{name}: report", text, ["report", "--format", "json"], "kriva"
    for name, text in imports():
        yield f"{name}: import", text, ["import", "-o", "OUT.kriva", "--sheet", "spline"], "svg"
    for sheet in "elevation", "subdivision", "combined":
        yield (f"table: 100,000 rows into {sheet}", lambda: "".join(f"{x} {y}\n" for x, y in randoms(100_000)),
               ["import", "-o", "OUT.kriva", "--sheet", sheet], "txt")


def make(file, text):
    """In a process of its own: a child's peak of memory is never below that of the process which started it."""
    child = os.fork()
    if child == 0:
        content = text()
        file.write_bytes(content if isinstance(content, bytes) else content.encode())
        os._exit(0)
    if os.waitpid(child, 0)[1] != 0:
        sys.exit(f"{file} could not be made")


def bound():
    resource.setrlimit(resource.RLIMIT_CPU, (ENOUGH_SECONDS, ENOUGH_SECONDS + 1))
    resource.setrlimit(resource.RLIMIT_AS, (ENOUGH_MEMORY, ENOUGH_MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def measured(program, command, folder):
    """Seconds of CPU, peak of memory in bytes, exit code and the first line on stderr."""
    environment = {"PATH": os.environ["PATH"], "HOME": str(folder), "LC_ALL": "C.UTF-8"}
    with open(folder / "stderr", "w+b") as errors:
        process = subprocess.Popen([program, *command], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=errors, env=environment, preexec_fn=bound)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        errors.seek(0)
        first = errors.readline(300).decode("utf-8", "replace").strip()
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024, process.returncode, first


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    program = pathlib.Path(sys.argv[1]).resolve() / "kriva"
    wanted = sys.argv[2:]
    count = beyond = 0
    made = None
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        print("  CPU s     MiB  code  input: command")
        for name, text, command, ending in runs():
            if wanted and not any(part in name for part in wanted):
                continue
            file = folder / f"input.{ending}"
            source = name.rsplit(":", 1)[0]
            if made != source:
                make(file, text)
                made = source
            command = [word.replace("OUT", str(folder / "out")) for word in command]
            seconds, memory, code, first = measured(program, command[:1] + [str(file)] + command[1:], folder)
            is_beyond = seconds > MOST_SECONDS or memory > MOST_MEMORY or code < 0
            count += 1
            beyond += is_beyond
            first = first.replace(str(file), "FILE")[:100]
            print(f"{seconds:7.2f} {memory / MEBIBYTE:7.0f} {code:5d}  {name}{' !' if is_beyond else ''}"
                  f"{'  ' + first if first else ''}", flush=True)
            for out in folder.glob("out*"):
                out.unlink()
    print(f"{count} runs, {beyond} beyond {MOST_SECONDS} s or 1 GiB")


if __name__ == "__main__":
    main()
