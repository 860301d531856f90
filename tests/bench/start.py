#!/usr/bin/env python3
"""Measures how long Kriva takes from its start until its window is painted, against a program with an empty window.

    start.py BUILD-FOLDER [RUNS]

Both are started in turn on a screen of their own, each time with an empty home. The clock stops when the middle of
the screen, black so far, shows something: the programs themselves know nothing of it."""
import contextlib
import mmap
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

WANTED = 2.0  # at most so many times the empty window's
SECONDS = 30


@contextlib.contextmanager
def screen(folder):
    """A display without window manager: its number and the bytes of its middle rows."""
    read, write = os.pipe()
    server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1280x800x24", "-fbdir", folder],
                              pass_fds=[write], stderr=subprocess.DEVNULL)
    os.close(write)
    try:
        with os.fdopen(read) as number:
            display = f":{number.readline().strip()}"
        with open(pathlib.Path(folder) / "Xvfb_screen0", "rb") as file:
            pixels = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
        middle = len(pixels) // 2
        yield display, lambda: pixels[middle:middle + (16 << 10)]
    finally:
        server.terminate()
        server.wait()


def time_to_paint(program):
    with tempfile.TemporaryDirectory() as home, screen(home) as (display, middle):
        environment = {"PATH": os.environ["PATH"], "HOME": home, "XDG_RUNTIME_DIR": home, "DISPLAY": display,
                       "QT_QPA_PLATFORM": "xcb", "LC_ALL": "C.UTF-8"}
        black = middle()
        start = time.monotonic()
        process = subprocess.Popen([program], env=environment, stderr=subprocess.DEVNULL)
        try:
            while middle() == black:
                if process.poll() is not None or time.monotonic() - start > SECONDS:
                    sys.exit(f"{program}: no window")
                time.sleep(0.0005)
            return time.monotonic() - start
        finally:
            process.kill()
            process.wait()


def main():
    build, runs = pathlib.Path(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 9
    programs = {"empty window": build / "tests" / "bench" / "empty_window", "kriva": build / "kriva"}
    times = {name: [] for name in programs}
    for run in range(runs + 1):
        for name, program in programs.items():
            taken = time_to_paint(program)
            if run > 0:  # the first fills the caches
                times[name].append(taken)
    middle = {name: statistics.median(taken) for name, taken in times.items()}
    for name, taken in times.items():
        print(f"{name}: {middle[name] * 1000:.0f} ms (from {min(taken) * 1000:.0f} to {max(taken) * 1000:.0f})")
    print(f"start: {middle['kriva'] / middle['empty window']:.2f} times the empty window, wanted at most {WANTED:g}")


if __name__ == "__main__":
    main()
