#!/usr/bin/env python3
"""That the comparison of reports fails where it should."""
import copy
import json
import pathlib
import sys
import unittest

sys.dont_write_bytecode = True
import check  # noqa: E402  (after the line above, which keeps the sources clean)

CASES = pathlib.Path(__file__).parent.parent / "data" / "cases"


def truth_of(name):
    return json.loads((CASES / f"{name}.truth.json").read_text(encoding="utf-8"))


class Comparison(unittest.TestCase):
    def setUp(self):
        self.truth = truth_of("two-lines-cross")
        self.got = copy.deepcopy({k: v for k, v in self.truth.items() if k != "check"})
        self.spline = self.got["sheets"]["spline"]

    def assert_differs(self, pattern):
        with self.assertRaisesRegex(check.Differs, pattern):
            check.compare_reports(self.truth, self.got)

    def test_every_truth_equals_itself(self):
        for path in sorted(CASES.glob("*.truth.json")):
            truth = json.loads(path.read_text(encoding="utf-8"))
            with self.subTest(path.name):
                check.compare_reports(truth, truth)

    def test_a_number_may_be_off_within_its_tolerance_only(self):
        self.spline["curves"][0]["length"] += 1e-15
        check.compare_reports(self.truth, self.got)
        self.spline["curves"][0]["length"] += 1e-6
        self.assert_differs("length: .*off by")

    def test_whole_numbers_have_no_tolerance(self):
        self.spline["curves"][0]["degree"] += 1
        self.assert_differs("degree")

    def test_a_missing_field_differs(self):
        del self.spline["curves"][0]["bounds"]
        self.assert_differs("bounds: missing")

    def test_a_crossing_too_few_too_many_or_elsewhere_differs(self):
        places = self.spline["crossings"]
        self.spline["crossings"] = []
        self.assert_differs("0 places, expected 1")
        self.spline["crossings"] = places * 2
        self.assert_differs("2 places, expected 1")
        self.spline["crossings"] = places
        places[0]["at"][0] += 0.5
        self.assert_differs("none fits")

    def test_fields_left_out_may_hold_anything(self):
        self.spline["crossings"] = None
        check.compare_reports(check.without(self.truth, {"crossings"}), self.got)


if __name__ == "__main__":
    unittest.main()
