#!/usr/bin/env python3
"""Opens the documents at the limits in the window and tells for how long it is dead at most.

    frames_bench.py BUILD-FOLDER [PART-OF-A-NAME...]

Milliseconds from an event to the end of the event loop's next turn: opening, zooming, Ctrl+A, an arrow key with all
points selected, its undo, and the other tabs."""
import pathlib
import subprocess
import sys
import tempfile

from limits_bench import documents, make

LONGEST = 250  # milliseconds
ENOUGH_SECONDS = 120


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    program = pathlib.Path(sys.argv[1]).resolve() / "tests" / "bench" / "frames"
    wanted = sys.argv[2:]
    count = beyond = 0
    with tempfile.TemporaryDirectory() as home:
        file = pathlib.Path(home) / "input.kriva"
        for name, text in documents():
            if wanted and not any(part in name for part in wanted):
                continue
            make(file, text)
            try:
                done = subprocess.run([program, file], env={"HOME": home, "LC_ALL": "C.UTF-8"}, capture_output=True,
                                      text=True, timeout=ENOUGH_SECONDS)
                told = done.stdout.strip() if done.returncode == 0 else f"code {done.returncode}"
            except subprocess.TimeoutExpired:
                told = f"more than {ENOUGH_SECONDS} s"
            times = [float(word) for word in told.split()[1::2]] if told.startswith("open") else []
            is_beyond = not times or max(times) > LONGEST
            count += 1
            beyond += is_beyond
            print(f"{told}  {name}{' !' if is_beyond else ''}", flush=True)
    print(f"{count} documents, {beyond} beyond {LONGEST} ms")


if __name__ == "__main__":
    main()
