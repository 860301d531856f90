#!/usr/bin/env python3
"""That the drawing of a small house shows its rooms, the arrows that are needed, and nothing on top of each other."""
import re
import sys
import unittest
import xml.etree.ElementTree as xml

sys.dont_write_bytecode = True
import check  # noqa: E402  (after the line above, which keeps the sources clean)
import drawing  # noqa: E402

HEIGHTS = check.floors("""
app
ui/panels ui/export
ui/canvas
core/spline core/combined
core/geometry
""")
GRAPH = {"app": ["ui/panels", "ui/canvas", "core/geometry"], "ui/panels": ["ui/canvas", "core/geometry"],
         "ui/export": ["core/spline", "core/geometry"], "ui/canvas": ["core/spline", "core/combined"],
         "core/spline": ["core/geometry"], "core/combined": [], "core/geometry": []}
NAMES = {"svg": "http://www.w3.org/2000/svg"}


def boxes(picture):
    return [tuple(float(box.get(key)) for key in ("x", "y", "width", "height"))
            for box in xml.fromstring(picture).findall("svg:rect[@class='room']", NAMES)]


class Drawing(unittest.TestCase):
    def setUp(self):
        self.picture = drawing.drawn(HEIGHTS, GRAPH)

    def test_arrows_that_follow_from_others_are_left_out(self):
        self.assertEqual(drawing.needed_arrows(GRAPH),
                         [("app", "ui/panels"), ("ui/panels", "ui/canvas"), ("ui/export", "core/spline"),
                          ("ui/canvas", "core/spline"), ("ui/canvas", "core/combined"),
                          ("core/spline", "core/geometry")])

    def test_each_room_has_a_box_and_its_name_as_text(self):
        texts = [text.text for text in xml.fromstring(self.picture).findall("svg:text", NAMES)]
        self.assertEqual(len(boxes(self.picture)), len(HEIGHTS))
        self.assertEqual(sorted(texts), sorted(["app", "ui", "core"] + [room.split("/")[-1] for room in HEIGHTS]))

    def test_boxes_stand_apart_and_inside_of_the_page(self):
        all_boxes = boxes(self.picture)
        width, height = (float(xml.fromstring(self.picture).get(key)) for key in ("width", "height"))
        for i, (x, y, w, h) in enumerate(all_boxes):
            self.assertTrue(0 < x and x + w < width and 0 < y and y + h < height)
            for x2, y2, w2, h2 in all_boxes[:i]:
                self.assertTrue(x + w < x2 or x2 + w2 < x or y + h < y2 or y2 + h2 < y)

    def test_lower_rooms_stand_lower(self):
        ys = dict(zip(HEIGHTS, (y for _, y, _, _ in boxes(self.picture))))
        for room, others in GRAPH.items():
            for other in others:
                self.assertLess(ys[room], ys[other])

    def test_an_arrow_ends_at_each_room_that_another_needs(self):
        self.assertEqual(self.picture.count('class="head"'), 5)

    def test_it_has_colours_for_dark_viewers_and_says_what_it_shows(self):
        light, dark = self.picture.split("prefers-color-scheme: dark")
        for kind in ("page", "house", "room", "arrow", "head"):
            self.assertRegex(light, rf"\.{kind} {{")
            self.assertRegex(dark, rf"\.{kind} {{")
        self.assertIn("<title", self.picture)

    def test_it_is_the_same_each_time(self):
        self.assertEqual(drawing.drawn(HEIGHTS, GRAPH), self.picture)
        self.assertIsNone(re.search(r"\d\.\d{3}", self.picture))


if __name__ == "__main__":
    unittest.main()
