#!/usr/bin/env python3
"""Draws the house as an SVG: floors.txt from the top down, a box for each room, and an arrow for each room that another
includes. What follows from other arrows is left out: who includes a room may include what stands below that, too.

    drawing.py            writes floors.svg beside this file
    drawing.py --check    whether floors.svg is what would be written; exit code 1 if not"""
import math
import sys

sys.dont_write_bytecode = True
import check  # noqa: E402  (after the line above, which keeps the sources clean)

PICTURE = check.HERE / "floors.svg"

WIDTH, BOX_WIDTH, BOX_HEIGHT, STOREY = 720, 116, 28, 58
MARGIN, HOUSE_GAP, HOUSE_LABEL = 16, 14, 56
LEAST_GAP = 22           # beside a box or an arrow that passes
CENTRING = 0.5           # how much the middle of the page draws, where an arrow draws as 1
ROUNDS = 200             # until places hardly move

STYLE = """
    .page { fill: #ffffff }
    .house { fill: #f4f5f7 }
    .room { fill: #ffffff; stroke: #8a94a3; stroke-width: 1 }
    .arrow { fill: none; stroke: #8a94a3; stroke-width: 1.2 }
    .head { fill: #8a94a3 }
    text { fill: #1f2733; font: 13px system-ui, "Helvetica Neue", Arial, sans-serif; text-anchor: middle }
    .name { font-weight: 600; text-anchor: start }
    @media (prefers-color-scheme: dark) {
      .page { fill: #14181f }
      .house { fill: #1d232c }
      .room { fill: #2a323e; stroke: #76818f }
      .arrow { stroke: #76818f }
      .head { fill: #76818f }
      text { fill: #e4e8ee }
    }
"""


def needed_arrows(graph):
    """The arrows that do not follow from others; the graph has no ring."""
    reached = {}

    def below(room):
        if room not in reached:
            reached[room] = set(graph[room]).union(*(below(other) for other in graph[room]))
        return reached[room]

    return [(room, other) for room in graph for other in graph[room]
            if not any(other in below(between) for between in graph[room] if between != other)]


class Layout:
    """Where boxes stand. Arrows to one room that pass a floor do it together, at a place of their own: such a place is
    named (room, floor), a box by its room."""

    def __init__(self, heights, arrows):
        top = max(heights.values())
        self.rows = [[] for _ in range(top + 1)]
        self.row_of = {}
        for room, height in heights.items():
            self._add(room, top - height)
        self.steps = []  # from one floor to the next
        for start, end in arrows:
            here = start
            for row in range(self.row_of[start] + 1, self.row_of[end] + 1):
                there = end if row == self.row_of[end] else (end, row)
                if there not in self.row_of:
                    self._add(there, row)
                if (here, there) not in self.steps:
                    self.steps.append((here, there))
                here = there
        self.x = {}
        self._place()

    def _add(self, node, row):
        self.rows[row].append(node)
        self.row_of[node] = row

    @staticmethod
    def half(node):
        return BOX_WIDTH / 2 if isinstance(node, str) else 0

    def _spread(self, row):
        """Puts the nodes of a row apart, in their order and near where they would like to be."""
        wanted = [self.x[node] for node in row]
        places, previous = [], None
        for node, place in zip(row, wanted):
            if previous is not None:
                place = max(place, places[-1] + self.half(previous) + LEAST_GAP + self.half(node))
            places.append(place)
            previous = node
        # All of them back by as much as they were pushed on average.
        shift = math.fsum(place - want for place, want in zip(places, wanted)) / len(row)
        for node, place in zip(row, places):
            self.x[node] = place - shift

    def _place(self):
        near = {node: [] for row in self.rows for node in row}
        for here, there in self.steps:
            pull = 1 + 3 * (self.half(here) == 0) + 3 * (self.half(there) == 0)  # what only passes does it straight
            near[here] += pull * [there]
            near[there] += pull * [here]
        for row in self.rows:
            for i, node in enumerate(row):
                self.x[node] = (i - (len(row) - 1) / 2) * (BOX_WIDTH + LEAST_GAP)
        for turn in range(ROUNDS):
            for row in self.rows if turn % 2 == 0 else self.rows[::-1]:
                for node in row:
                    self.x[node] = math.fsum(self.x[other] for other in near[node]) / (len(near[node]) + CENTRING)
                if turn < ROUNDS // 2:
                    row.sort(key=lambda node: self.x[node])  # later on nobody changes places
                self._spread(row)
        left = min(self.x[node] - self.half(node) for node in self.x)
        right = max(self.x[node] + self.half(node) for node in self.x)
        middle = (WIDTH + MARGIN + HOUSE_LABEL) / 2
        self.x = {node: round(place - (left + right) / 2 + middle) for node, place in self.x.items()}


def houses(rows):
    """The first and the last row of each house, from the top."""
    found = {}
    for i, row in enumerate(rows):
        for room in row:
            if isinstance(room, str):
                first, _ = found.get(room.split("/")[0], (i, i))
                found[room.split("/")[0]] = (first, i)
    return found


def drawn(heights, graph):
    """The SVG as text; `graph` tells which rooms each room includes."""
    layout = Layout(heights, needed_arrows(graph))
    bands = houses(layout.rows)
    order = list(bands)

    def top(row):
        """Of the boxes of a row: each house begins a little lower."""
        house = next(i for i, name in enumerate(order) if bands[name][0] <= row <= bands[name][1])
        return MARGIN + (STOREY - BOX_HEIGHT) // 2 + row * STOREY + house * HOUSE_GAP

    height = top(len(layout.rows) - 1) + BOX_HEIGHT + (STOREY - BOX_HEIGHT) // 2 + MARGIN
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" '
             f'height="{height}" role="img" aria-labelledby="title description">',
             '  <title id="title">The floors of the house</title>',
             '  <desc id="description">Rooms by floors, from the top down. An arrow leads to what a room includes; '
             'arrows that follow from others are left out.</desc>',
             f'  <style>{STYLE}  </style>',
             f'  <rect class="page" width="{WIDTH}" height="{height}"/>']
    for name, (first, last) in bands.items():
        start = top(first) - (STOREY - BOX_HEIGHT) // 2
        lines.append(f'  <rect class="house" x="{MARGIN}" y="{start}" width="{WIDTH - 2 * MARGIN}" '
                     f'height="{(last - first + 1) * STOREY}" rx="8"/>')
        lines.append(f'  <text class="name" x="{MARGIN + 14}" y="{top(first) + BOX_HEIGHT // 2 + 5}">{name}</text>')
    for here, there in layout.steps:
        x0, y0 = layout.x[here], top(layout.row_of[here]) + (BOX_HEIGHT if isinstance(here, str) else BOX_HEIGHT // 2)
        x1, y1 = layout.x[there], top(layout.row_of[there]) + (-6 if isinstance(there, str) else BOX_HEIGHT // 2)
        middle = (y0 + y1) // 2
        lines.append(f'  <path class="arrow" d="M{x0} {y0}C{x0} {middle} {x1} {middle} {x1} {y1}"/>')
    for room in dict.fromkeys(there for _, there in layout.steps if isinstance(there, str)):
        x, y = layout.x[room], top(layout.row_of[room])
        lines.append(f'  <path class="head" d="M{x} {y}L{x - 4} {y - 8}L{x + 4} {y - 8}Z"/>')
    for room in heights:
        x, y = layout.x[room], top(layout.row_of[room])
        lines.append(f'  <rect class="room" x="{x - BOX_WIDTH // 2}" y="{y}" width="{BOX_WIDTH}" '
                     f'height="{BOX_HEIGHT}" rx="5"/>')
        lines.append(f'  <text x="{x}" y="{y + BOX_HEIGHT // 2 + 5}">{room.split("/")[-1]}</text>')
    return "\n".join([*lines, "</svg>", ""])


def main():
    heights = check.floors((check.HERE / "floors.txt").read_text(encoding="utf-8"))
    files = check.sources(check.HERE.parent.parent)
    picture = drawn(check.each_height(files, heights),
                    check.arrows(files, lambda path: check.room_of(path, heights)))
    if sys.argv[1:] == ["--check"]:
        if PICTURE.exists() and PICTURE.read_text(encoding="utf-8") == picture:
            return 0
        print("floors.svg shows another house: run tests/architecture/drawing.py")
        return 1
    PICTURE.write_text(picture, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
