#!/usr/bin/env python3
"""Checks that the path of each test says what it tests.

    tests/core/bezier/split_test.cpp        core/bezier/split.h or .cpp; likewise for ui, app and resources
    tests/core/bezier/split_speed_test.cpp  the same, and what of it
    tests/core/sheets/spline/chain_test.cpp the folder core/sheets/spline/chain; chain_speed_test.cpp and what of it
    tests/support/dice_test.cpp             tests/support/dice.h or .cpp
    tests/window/panels/wheel_test.cpp      ui/panels, driven in the whole window
    tests/window/typing_test.cpp            the whole window
    tests/desktop/keyboard_test.cpp         the whole window on a display with a window manager
    tests/fifth_sheet/offset_test.cpp       the sheet that stands in that folder alone

    mirror.py [FOLDER]     the project's folder

One line for each fault; exit code 1 if there is one."""
import pathlib
import sys

HERE = pathlib.Path(__file__).parent
SUFFIX = "_test.cpp"


def names_tested(path):
    """What a test may be named after, the longest name first: a test of `split_speed` tests that or `split`."""
    folder, slash, name = path.removesuffix(SUFFIX).rpartition("/")
    words = name.split("_")
    return [folder + slash + "_".join(words[:count]) for count in range(len(words), 0, -1)]


def fault_of(test, is_there):
    """What is wrong with the path of a test, counted from the folder of tests, if anything. `is_there` tells whether
    the project has this file or folder."""
    house, _, rest = test.partition("/")
    folder = rest.rpartition("/")[0]
    if house in ("desktop", "fifth_sheet") and not folder:
        return None
    if house == "window":
        return None if is_there(f"ui/{folder}") else f"drives ui/{folder}, which is no folder"
    mirrored = f"tests/{test}" if house == "support" else test
    if house in ("core", "ui", "app", "resources", "support"):
        if any(is_there(name + ending) for name in names_tested(mirrored) for ending in ("", ".h", ".cpp")):
            return None
    return "is named after no source"


def faults(tests, is_there):
    for test in tests:
        fault = fault_of(test, is_there)
        if fault:
            yield f"tests/{test}: {fault}"


def main():
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else HERE.parent.parent
    tests = sorted(str(path.relative_to(root / "tests")) for path in (root / "tests").rglob("*" + SUFFIX))
    found = list(faults(tests, lambda name: (root / name).exists()))
    print(*found, f"{len(tests)} tests, {len(found)} faults", sep="\n")
    return 0 if tests and not found else 1


if __name__ == "__main__":
    sys.exit(main())
