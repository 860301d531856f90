#!/usr/bin/env python3
"""That the check of the architecture finds faults planted in small trees, and nothing in a clean one."""
import sys
import unittest

sys.dont_write_bytecode = True
import check  # noqa: E402  (after the line above, which keeps the sources clean)

# A small house of its own, so that these tests stay when rooms move.
HEIGHTS = check.floors("""
# a comment is no floor
app
ui/panels ui/export
ui/canvas
core/sheets/
core/geometry core/numbers
""")
BANNED = (check.HERE / "banned.txt").read_text(encoding="utf-8")

CLEAN = {
    "core/geometry/point.h": "#include <cmath>",
    "core/numbers/double_double.h": "",
    "core/sheets/spline/spline.h": '#include "core/geometry/point.h"\n#include "core/numbers/double_double.h"',
    "core/sheets/spline/editing/edits.h": '#include "core/sheets/spline/spline.h"',
    "core/sheets/combined/combined.h": '#include "core/geometry/point.h"',
    "ui/canvas/view.h": '#include <QWidget>\n#include "ui/canvas/drawing/stroke.h"',
    "ui/canvas/drawing/stroke.h": '#include "ui/canvas/base/viewport.h"',
    "ui/canvas/base/viewport.h": '#include "core/sheets/spline/editing/edits.h"',
    "ui/panels/panel.h": '#include "ui/canvas/view.h"',
    "ui/export/dialog.h": '#include "core/geometry/point.h"',
    "app/main.cpp": '#include "ui/panels/panel.h"\n#include "main.moc"',
}


def faults(changes):
    files = {**CLEAN, **changes}
    return [*check.room_faults(files, HEIGHTS), *check.include_faults(files, HEIGHTS),
            *check.ring_faults(files, HEIGHTS)]


class Floors(unittest.TestCase):
    def assert_refused(self, path, text, pattern):
        found = faults({path: text})
        self.assertEqual(len(found), 1, found)
        self.assertRegex(found[0], pattern)
        self.assertTrue(found[0].startswith(path), found[0])

    def test_a_clean_tree_has_no_fault(self):
        self.assertEqual(faults({}), [])

    def test_floors_are_read_from_the_top_down(self):
        self.assertEqual(check.floors("# roof\na\n\nb/c d\n"), {"a": 1, "b/c": 0, "d": 0})

    def test_the_projects_own_floors_lead_from_app_to_the_ground(self):
        own = check.floors((check.HERE / "floors.txt").read_text(encoding="utf-8"))
        height = {house: [height for room, height in own.items() if room.split("/")[0] == house]
                  for house in ("app", "ui", "core")}
        self.assertGreater(min(height["app"]), max(height["ui"]))
        self.assertGreater(min(height["ui"]), max(height["core"]))

    def test_core_knows_no_qt(self):
        for header in ("QString", "QtCore/QString", "qglobal.h"):
            self.assert_refused("core/geometry/writer.h", f"#include <{header}>", "knows no Qt")

    def test_no_arrow_points_up(self):
        self.assert_refused("core/geometry/box.h", '#include "core/sheets/spline/spline.h"',
                            "core/sheets/spline stands above core/geometry")
        self.assert_refused("core/geometry/box.h", '#include "ui/canvas/view.h"', "stands above")
        self.assert_refused("ui/canvas/scene.cpp", '  #  include "app/main.cpp"', "stands above")

    def test_rooms_on_one_floor_do_not_know_each_other(self):
        self.assert_refused("core/sheets/spline/joins.h", '#include "core/sheets/combined/combined.h"',
                            "core/sheets/combined stands beside core/sheets/spline")
        self.assert_refused("ui/panels/list.h", '#include "ui/export/dialog.h"', "stands beside")

    def test_a_subfolder_stands_on_the_floor_of_its_room(self):
        self.assert_refused("ui/panels/plots/view.h", '#include "ui/export/dialog.h"', "stands beside")
        self.assert_refused("core/numbers/big/number.h", '#include "core/sheets/spline/editing/edits.h"',
                            "stands above")

    def test_a_file_in_no_room_is_a_fault(self):
        for path in ("core/misc/things.h", "core/things.h", "core/sheets/things.h", "ui/canvases/things.h"):
            self.assert_refused(path, '#include "ui/panels/panel.h"', "stands in no room")

    def test_a_room_without_sources_is_a_fault(self):
        files = {path: text for path, text in CLEAN.items() if path != "ui/export/dialog.h"}
        self.assertEqual(list(check.room_faults(files, HEIGHTS)), ["floors.txt: ui/export is no folder with sources"])

    def test_includes_are_written_from_the_project_folder(self):
        self.assert_refused("core/geometry/box.h", '#include "point.h"', "no file counted from")


class Rings(unittest.TestCase):
    def test_a_ring_of_files_is_found(self):
        ring = {"ui/canvas/a.h": '#include "ui/canvas/b.h"', "ui/canvas/b.h": '#include "ui/canvas/c.h"',
                "ui/canvas/c.h": '#include "ui/canvas/a.h"'}
        self.assertEqual(faults(ring),
                         ["ring of includes: ui/canvas/a.h -> ui/canvas/b.h -> ui/canvas/c.h -> ui/canvas/a.h"])

    def test_a_ring_of_subfolders_is_found(self):
        self.assertEqual(faults({"ui/canvas/base/grid.h": '#include "ui/canvas/drawing/stroke.h"'}),
                         ["ring of folders: ui/canvas/drawing -> ui/canvas/base -> ui/canvas/drawing"])

    def test_the_folder_of_the_room_itself_is_part_of_rings(self):
        self.assertEqual(faults({"ui/canvas/drawing/hatch.h": '#include "ui/canvas/other.h"', "ui/canvas/other.h": ""}),
                         ["ring of folders: ui/canvas -> ui/canvas/drawing -> ui/canvas"])

    def test_a_ring_through_a_folder_in_a_folder_is_found(self):
        ring = {"ui/canvas/base/deep/deep.h": '#include "ui/canvas/drawing/stroke.h"',
                "ui/canvas/base/wide.h": '#include "ui/canvas/base/deep/deep.h"'}
        self.assertEqual(faults(ring), ["ring of folders: ui/canvas/drawing -> ui/canvas/base -> ui/canvas/base/deep"
                                        " -> ui/canvas/drawing"])

    def test_folders_of_two_rooms_make_no_ring_but_an_arrow_up(self):
        self.assertEqual(faults({"ui/canvas/list.h": '#include "ui/panels/panel.h"'}),
                         ["ui/canvas/list.h: includes ui/panels/panel.h, and ui/panels stands above ui/canvas"])


class House(unittest.TestCase):
    def test_arrows_are_told_once_and_between_rooms_alone(self):
        twice = {**CLEAN, "ui/panels/list.h": '#include "ui/canvas/view.h"\n#include "ui/panels/panel.h"'}
        rooms = check.arrows(twice, lambda path: check.room_of(path, HEIGHTS))
        self.assertEqual(rooms["ui/panels"], ["ui/canvas"])
        self.assertEqual(rooms["ui/canvas"], ["core/sheets/spline"])
        self.assertEqual(rooms["core/sheets/spline"], ["core/geometry", "core/numbers"])
        self.assertEqual(rooms["core/geometry"], [])

    def test_the_house_is_told_from_the_top_with_its_numbers(self):
        lines = list(check.room_lines(CLEAN, HEIGHTS))
        self.assertEqual(lines[0], "app -> ui/panels")
        self.assertIn("core/sheets/spline -> core/geometry, core/numbers", lines)
        self.assertIn("core/geometry -> nothing", lines)
        self.assertEqual(lines[-3:], ["8 rooms, 7 arrows between them", "11 folders, 10 arrows between them", "0 rings"])

    def test_rings_are_told_and_counted(self):
        ring = {**CLEAN, "ui/canvas/base/grid.h": '#include "ui/canvas/drawing/stroke.h"'}
        lines = list(check.room_lines(ring, HEIGHTS))
        self.assertIn("ring: ui/canvas/drawing -> ui/canvas/base -> ui/canvas/drawing", lines)
        self.assertEqual(lines[-1], "1 rings")

    def test_the_projects_own_house_has_no_ring(self):
        files = check.sources(check.HERE.parent.parent)
        own = check.floors((check.HERE / "floors.txt").read_text(encoding="utf-8"))
        self.assertGreater(len(files), 100)
        self.assertEqual(list(check.room_lines(files, own))[-1], "0 rings")


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
