#!/usr/bin/env python3
"""Checks the sizes of the sources of core, ui and app: of a header with its source, of a folder and of functions.

Labels of a switch do not count, for tables that the compiler checks are made of them. A function behind
NOLINTNEXTLINE(readability-function-size) is not looked at.

    sizes.py [FOLDER]     the project's folder

One line for each fault; exit code 1 if there is one."""
import pathlib
import re
import sys

sys.dont_write_bytecode = True
import check  # noqa: E402  (after the line above, which keeps the sources clean)

MOST_LINES = 300        # of a header with its source
MOST_HEADERS = 12       # of a folder
MOST_IN_FUNCTION = 40   # lines between the braces
MOST_IN_ALGORITHM = 60  # the same in core, where the algorithms are

LABEL = re.compile(r"\s*(case\b.*|default):\s*")
EXEMPT = "NOLINTNEXTLINE(readability-function-size)"

# What stands before a brace that holds functions.
OUTSIDE = re.compile(r"\b(namespace|class|struct|union|enum)\b(?!.*\))", re.DOTALL)


def blank(text):
    """The same lines without comments, literals and the preprocessor's."""
    return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", lambda found: "\n" * found.group().count("\n"),
                  check.code_alone(text), flags=re.MULTILINE)


def name_of(head):
    """What a function's head names, for people to find it."""
    before = head.split("(")[0].split()
    return before[-1] if before else "?"


def functions(text):
    """Name, first line and lines between the braces of each function; lambdas belong to the one that they stand in."""
    lines = text.splitlines()
    stack = []  # for each open brace: whether functions may stand in it, what stands before it, its line
    head_start, line = 0, 1
    code = blank(text)
    for at, sign in enumerate(code):
        if sign == "\n":
            line += 1
        elif sign == "{":
            head = code[head_start:at].strip()
            is_outside = all(holds for holds, _, _ in stack)
            stack.append((is_outside and OUTSIDE.search(head) is not None, head, line))
            head_start = at + 1
        elif sign == "}" and stack:
            holds, head, first = stack.pop()
            head_start = at + 1
            if holds or "(" not in head or not all(outer for outer, _, _ in stack):
                continue
            before = lines[max(0, first - 2 - head.count("\n")):first - 1]
            if not any(EXEMPT in comment for comment in before):
                yield name_of(head), first, sum(not LABEL.fullmatch(inner) for inner in lines[first:line - 1])
        elif sign == ";":
            head_start = at + 1


def file_faults(files):
    """`files` maps the path of each source to its text."""
    lines = {}
    for path, text in files.items():
        unit = path.rsplit(".", 1)[0]
        lines[unit] = lines.get(unit, 0) + text.count("\n")
    for unit, count in lines.items():
        if count > MOST_LINES:
            yield f"{unit}: {count} lines with its header, beyond {MOST_LINES}"


def folder_faults(files):
    headers = {}
    for path in files:
        if path.endswith(".h"):
            headers[check.folder_of(path)] = headers.get(check.folder_of(path), 0) + 1
    for folder, count in headers.items():
        if count > MOST_HEADERS:
            yield f"{folder}: {count} headers, beyond {MOST_HEADERS}"


def function_faults(files):
    for path, text in files.items():
        most = MOST_IN_ALGORITHM if path.startswith("core/") else MOST_IN_FUNCTION
        for name, line, count in functions(text):
            if count > most:
                yield f"{path}:{line}: {name} has {count} lines, beyond {most}"


def faults(files):
    return [*file_faults(files), *folder_faults(files), *function_faults(files)]


def main():
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else check.HERE.parent.parent
    files = check.sources(root)
    found = faults(files)
    print(*found, f"{len(files)} sources, {len(found)} faults", sep="\n")
    return 0 if files and not found else 1


if __name__ == "__main__":
    sys.exit(main())
