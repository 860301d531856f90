#!/usr/bin/env python3
"""That the check of the tests' paths finds a test that is named after nothing, and lets the others be."""
import sys
import unittest

sys.dont_write_bytecode = True
import mirror  # noqa: E402  (after the line above, which keeps the sources clean)

THERE = {"core/bezier", "core/bezier/split.h", "core/bezier/split.cpp", "core/bezier/measures", "resources/examples",
         "app/main.cpp", "ui/panels", "ui/", "ui/panels/list.h", "tests/support/dice.h", "resources/guide/update"}


def fault(test):
    return mirror.fault_of(test, THERE.__contains__)


class Mirror(unittest.TestCase):
    def test_a_test_is_named_after_a_source(self):
        for test in ("core/bezier/split_test.cpp", "ui/panels/list_test.cpp", "app/main_test.cpp",
                     "resources/guide/update_test.cpp", "support/dice_test.cpp"):
            with self.subTest(test):
                self.assertIsNone(fault(test))

    def test_or_after_a_folder(self):
        self.assertIsNone(fault("core/bezier/measures_test.cpp"))
        self.assertIsNone(fault("resources/examples_test.cpp"))

    def test_and_may_say_what_of_it(self):
        self.assertIsNone(fault("core/bezier/split_far_away_test.cpp"))
        self.assertIsNone(fault("core/bezier/measures_speed_test.cpp"))

    def test_a_name_that_only_begins_alike_is_none(self):
        self.assertRegex(fault("core/bezier/splitting_test.cpp"), "no source")
        self.assertRegex(fault("core/bezier/sp_test.cpp"), "no source")

    def test_a_test_of_nothing_is_a_fault(self):
        for test in ("core/bezier/join_test.cpp", "core/geometry/split_test.cpp", "bezier/split_test.cpp",
                     "split_test.cpp", "core/window/list_test.cpp", "desktop/keys/list_test.cpp"):
            with self.subTest(test):
                self.assertRegex(fault(test), "no source")

    def test_the_whole_window_is_driven_room_by_room(self):
        self.assertIsNone(fault("window/typing_test.cpp"))
        self.assertIsNone(fault("window/panels/wheel_test.cpp"))
        self.assertIsNone(fault("desktop/keyboard_test.cpp"))
        self.assertRegex(fault("window/rooms/wheel_test.cpp"), "ui/rooms, which is no folder")

    def test_faults_name_the_file(self):
        self.assertEqual(list(mirror.faults(["core/bezier/split_test.cpp", "core/a_test.cpp"], THERE.__contains__)),
                         ["tests/core/a_test.cpp: is named after no source"])


if __name__ == "__main__":
    unittest.main()
