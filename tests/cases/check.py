#!/usr/bin/env python3
"""Compares the report of every case with the truth beside it.

    check.py --kriva PROGRAM [--without FIELD,FIELD] FOLDER [NAME ...]

FOLDER holds pairs NAME.kriva and NAME.truth.json; the truth is the report, and under "check" how far each field may
be off. One line for each case that fails, with the first field that differs; the last line counts."""
import argparse
import json
import os
import pathlib
import subprocess
import sys

SECONDS = 20
KNOT = 1e-7  # a parameter this close to an end of its segment is at the knot


class Differs(Exception):
    pass


def is_number(x):
    return isinstance(x, (int, float)) and not isinstance(x, bool)


def short(x):
    text = json.dumps(x)
    return text if len(text) < 60 else text[:57] + "..."


def without(truth, names):
    """The truth without the fields of these names; the report may then hold anything there."""
    if isinstance(truth, dict):
        return {k: without(v, names) for k, v in truth.items() if k not in names}
    return [without(x, names) for x in truth] if isinstance(truth, list) else truth


class Fields:
    """Compares field by field; a tolerance holds for all below it that has none of its own."""

    def __init__(self, check):
        self.tolerance = check["tolerance"]
        self.unchecked = set(check["unchecked"])

    def compare(self, want, got, path, tolerance=None):
        if path in self.unchecked:
            return
        tolerance = self.tolerance.get(path, tolerance)
        if isinstance(want, dict):
            self.objects(want, got, path, tolerance)
        elif isinstance(want, list):
            self.lists(want, got, path, tolerance)
        elif is_number(want):
            self.numbers(want, got, path, 0 if isinstance(want, int) else tolerance or 0)
        elif type(want) is not type(got) or want != got:
            raise Differs(f"{path}: {short(got)}, expected {short(want)}")

    def objects(self, want, got, path, tolerance):
        if not isinstance(got, dict):
            raise Differs(f"{path}: {short(got)}, expected an object")
        if want.get("incomplete") and set(got) != set(want):
            raise Differs(f"{path}: {sorted(got)}, expected {sorted(want)} of an incomplete curve")
        for key, value in want.items():
            if key in ("crossings", "overlaps"):
                continue  # compared as sets, see Places
            if key not in got:
                raise Differs(f"{path}.{key}: missing")
            self.compare(value, got[key], f"{path}.{key}", tolerance)

    def lists(self, want, got, path, tolerance):
        if not isinstance(got, list) or len(got) != len(want):
            found = f"{len(got)} elements" if isinstance(got, list) else short(got)
            raise Differs(f"{path}: {found}, expected {len(want)} elements")
        for i, (a, b) in enumerate(zip(want, got)):
            self.compare(a, b, f"{path}[{i}]", tolerance[i] if isinstance(tolerance, list) else tolerance)

    @staticmethod
    def numbers(want, got, path, tolerance):
        if not is_number(got):
            raise Differs(f"{path}: {short(got)}, expected {want!r}")
        if not abs(got - want) <= tolerance:
            off = abs(got - want)
            raise Differs(f"{path}: {got!r}, expected {want!r} (off by {off:.3g}, allowed {tolerance:.3g})")


class Places:
    """Compares crossings and overlaps: the order of places that are equally first is free, and near a knot a pass may
    be told on either segment."""

    def __init__(self, truth):
        self.sheet = truth["sheets"]["spline"]
        self.tolerance = truth["check"]["tolerance"]
        self.unchecked = set(truth["check"]["unchecked"])

    def canonical(self, p):
        """(curve, segment, t) with a pass at a knot on the segment that starts there, passing over segments of one
        point."""
        curve, segment, t = p["curve"], p["segment"], p["t"]
        segments = self.sheet["curves"][curve]["segments"]
        closed = len(segments) == len(self.sheet["curves"][curve]["knots"])
        dead = [all(q == s["points"][0] for q in s["points"]) for s in segments]
        if t > 1 - KNOT or dead[segment]:
            following = segment
            while closed or following + 1 < len(segments):
                following = (following + 1) % len(segments)
                if not dead[following]:
                    return curve, following, 0.0
                if following == segment:
                    break
            while dead[segment] and segment > 0:
                segment, t = segment - 1, 1.0
        return curve, segment, t

    def same_passes(self, want, got, tolerance):
        rest = [self.canonical(p) for p in got]
        for curve, segment, t in map(self.canonical, want):
            fit = next((q for q in rest if q[:2] == (curve, segment) and abs(q[2] - t) <= tolerance), None)
            if fit is None:
                return False
            rest.remove(fit)
        return not rest

    def crossings(self, got):
        path = "sheets.spline.crossings"
        want, left = self.sheet["crossings"], list(got)
        printed = [[(p["curve"], p["segment"], p["t"]) for p in x["passes"]] for x in got]
        if any(p != sorted(p) for p in printed) or printed != sorted(printed, key=lambda p: p[0]):
            raise Differs(f"{path}: not sorted by curve, segment, t of their passes")
        for i, place in enumerate(want):
            tolerance = self.tolerance.get(f"{path}[{i}]", self.tolerance[path])
            near = self.tolerance[f"{path}[{i}].at"]
            fit = next((x for x in left if all(abs(a - b) <= near for a, b in zip(x["at"], place["at"], strict=True))
                        and self.same_passes(place["passes"], x["passes"], tolerance)), None)
            if fit is None:
                raise Differs(f"{path}: {len(got)} places, expected {len(want)}; none fits {short(place)}")
            left.remove(fit)
        if left:
            raise Differs(f"{path}: {len(got)} places, expected {len(want)}; no crossing at {short(left[0])}")

    def overlaps(self, got):
        path = "sheets.spline.overlaps"
        want, left, tolerance = self.sheet["overlaps"], list(got), self.tolerance.get("sheets.spline.overlaps", KNOT)

        def ends(passes, turned):
            names = ("to", "from") if turned else ("from", "to")
            return [(p["curve"], p["segment"], p[names[0]], p[names[1]]) for p in passes]

        def fits(a, b):
            return all(p[:2] == q[:2] and abs(p[2] - q[2]) <= tolerance and abs(p[3] - q[3]) <= tolerance
                       for p, q in zip(a, b, strict=True))

        if len(got) != len(want):
            raise Differs(f"{path}: {short(got)}, expected {len(want)} elements")
        for part in want:
            fit = next((x for x in left if any(fits(ends(part["passes"], turned), ends(x["passes"], False))
                                               for turned in (False, True))), None)
            if fit is None:
                raise Differs(f"{path}: none fits {short(part)}")
            left.remove(fit)

    def compare(self, got):
        for name in ("crossings", "overlaps"):
            if name in self.sheet and f"sheets.spline.{name}" not in self.unchecked:
                getattr(self, name)(got[name])


def compare_reports(truth, got):
    fields = Fields(truth["check"])
    for key in ("format", "version", "document"):
        fields.compare(truth[key], got[key], key)
    for name, want in truth["sheets"].items():
        if want["curves"] or got["sheets"].get(name, {}).get("curves"):  # an empty sheet may be left out
            fields.compare(want, got["sheets"][name], f"sheets.{name}")
            if name == "spline":
                Places(truth).compare(got["sheets"][name])


def report_of(program, document):
    environment = dict(os.environ, QT_QPA_PLATFORM="offscreen")
    try:
        done = subprocess.run([program, "report", document, "--format", "json"], stdin=subprocess.DEVNULL,
                              capture_output=True, timeout=SECONDS, env=environment)
    except subprocess.TimeoutExpired:
        raise Differs(f"no end after {SECONDS} s") from None
    if done.returncode != 0:
        raise Differs(f"exit code {done.returncode}: {done.stderr.decode('utf-8', 'replace').strip()[:200]}")
    return json.loads(done.stdout)


def check(program, document, left_out):
    truth = without(json.loads(document.with_suffix(".truth.json").read_text(encoding="utf-8")), left_out)
    try:
        compare_reports(truth, report_of(program, document))
    except (KeyError, TypeError, ValueError, IndexError) as error:
        raise Differs(f"the report cannot be read: {type(error).__name__} {error}") from error


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kriva", required=True)
    parser.add_argument("--without", default="", help="names of fields not to look at")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("name", nargs="*")
    options = parser.parse_args()
    cases = [x for x in sorted(options.folder.glob("*.kriva")) if not options.name or x.stem in options.name]
    held = 0
    for document in cases:
        try:
            check(options.kriva, document, set(options.without.split(",")))
            held += 1
        except Differs as difference:
            print(f"{document.stem}: {difference}")
    print(f"{held} of {len(cases)} cases hold")
    return 0 if cases and held == len(cases) else 1


if __name__ == "__main__":
    sys.exit(main())
