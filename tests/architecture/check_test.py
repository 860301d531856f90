#!/usr/bin/env python3
"""That the check of the architecture finds faults planted in small trees, and nothing in a clean one."""
import sys
import unittest

sys.dont_write_bytecode = True
import check  # noqa: E402  (after the line above, which keeps the sources clean)

ARROWS = check.arrows((check.HERE / "arrows.txt").read_text(encoding="utf-8"))
BANNED = (check.HERE / "banned.txt").read_text(encoding="utf-8")

CLEAN = {
    "core/geometry/point.h": "#include <cmath>",
    "core/document/document.h": '#include "core/spline/spline_sheet.h"',
    "core/spline/spline_sheet.h": '#include "core/geometry/point.h"',
    "core/combined/combined_sheet.h": '#include "core/geometry/point.h"',
    "ui/sheets/sheet_tab.h": '#include <QObject>\n#include "core/document/document.h"',
    "ui/sheets/spline/spline_tab.h": '#include "core/spline/spline_sheet.h"\n#include "ui/sheets/sheet_tab.h"',
    "app/sheet_catalog.cpp": '#include "ui/sheets/spline/spline_tab.h"\n#include "sheet_catalog.moc"',
    "app/main.cpp": '#include "ui/sheets/sheet_tab.h"',
}


class Includes(unittest.TestCase):
    def assert_refused(self, path, line, pattern="against arrows.txt"):
        faults = list(check.include_faults({**CLEAN, path: line}, ARROWS))
        self.assertEqual(len(faults), 1, faults)
        self.assertRegex(faults[0], pattern)
        self.assertTrue(faults[0].startswith(path))

    def test_a_clean_tree_has_no_fault(self):
        self.assertEqual(list(check.include_faults(CLEAN, ARROWS)), [])
        self.assertEqual(list(check.ring_faults(CLEAN)), [])

    def test_core_knows_no_qt(self):
        for header in ("QString", "QtCore/QString", "qglobal.h"):
            self.assert_refused("core/io/writer.h", f"#include <{header}>", "knows no Qt")

    def test_no_arrow_points_back(self):
        self.assert_refused("core/io/writer.h", '#include "ui/sheets/sheet_tab.h"')
        self.assert_refused("ui/canvas/view.h", '#include "app/main.cpp"')
        self.assert_refused("core/geometry/box.h", '#include "core/spline/spline_sheet.h"')
        self.assert_refused("core/bezier/split.h", '  #  include "core/document/document.h"')

    def test_sheets_do_not_know_each_other(self):
        self.assert_refused("core/elevation/elevate.h", '#include "core/combined/combined_sheet.h"')
        self.assert_refused("ui/sheets/elevation/tab.h", '#include "ui/sheets/spline/spline_tab.h"')
        self.assert_refused("ui/sheets/elevation/tab.h", '#include "core/spline/spline_sheet.h"')

    def test_only_the_catalogue_knows_the_tabs(self):
        self.assert_refused("ui/shell/main_window.h", '#include "ui/sheets/spline/spline_tab.h"')
        self.assert_refused("app/command.h", '#include "ui/sheets/spline/spline_tab.h"')

    def test_a_folder_without_a_rule_is_a_fault(self):
        self.assert_refused("core/misc/things.h", "", "no line of arrows.txt")

    def test_includes_are_written_from_the_project_folder(self):
        self.assert_refused("core/geometry/box.h", '#include "point.h"', "no file counted from")

    def test_a_ring_is_found(self):
        ring = {"ui/a.h": '#include "ui/b.h"', "ui/b.h": '#include "ui/c.h"', "ui/c.h": '#include "ui/a.h"'}
        self.assertEqual(list(check.ring_faults(ring)), ["ring of includes: ui/a.h -> ui/b.h -> ui/c.h -> ui/a.h"])


class Banned(unittest.TestCase):
    def faults(self, text, path="ui/panels/field.cpp"):
        return list(check.banned_faults({path: text}, BANNED))

    def test_every_banned_name_is_found(self):
        for call in ("strtod(s, nullptr)", "atof(s)", "std::stod(s)", "sscanf(s, f)", "std::to_string(1.0)",
                     "std::printf(f)", "std::ostringstream out", "QSvgGenerator g", "QDoubleSpinBox* box",
                     "QSaveFile file", "std::ofstream out"):
            with self.subTest(call):
                self.assertRegex("".join(self.faults(f"int a;\n{call};")), r"^ui/panels/field\.cpp:2: ")

    def test_comments_and_literals_are_not_looked_at(self):
        self.assertEqual(self.faults('// never atof\n/* strtod\n */ f("atof", \'"\'); g("\\"strtod");'), [])
        self.assertEqual(self.faults('f(R"x(" atof)x");'), [])

    def test_code_between_them_is(self):
        self.assertRegex(self.faults('/* a\n"b */ atof(s); // c')[0], r":2: atof")
        self.assertRegex(self.faults("f(10'000, atof(s), 20'000);")[0], r":1: atof")

    def test_names_that_only_contain_one_are_free(self):
        self.assertEqual(self.faults("my_atof(s); QSaveFiles x;"), [])

    def test_safe_write_alone_may_use_what_it_replaces(self):
        self.assertEqual(self.faults("QSaveFile file;", "ui/document/safe_write.cpp"), [])


if __name__ == "__main__":
    unittest.main()
