"""Uses pages of `gnomon render` as a person would: GNOMON=PROGRAM EXAMPLES=FOLDER CHROMIUM=PROGRAM page_test.py

Pointer and keys are real ones, which the browser hands to the page. Whatever a page says on its console is a mistake.
"""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from chromium import Chromium

GNOMON, EXAMPLES, CHROMIUM = (os.environ[name] for name in ("GNOMON", "EXAMPLES", "CHROMIUM"))

LIT, PENUMBRA, UMBRA = (255, 247, 219), (120, 181, 227), (18, 56, 107)
FULL = (251, 244, 136)  # the end of the scale of irradiance
BLOCKER_IN_PLANE = (214, 94, 0)


def square(half, z, x=0):
    return [[x - half, -half, z], [x + half, -half, z], [x + half, half, z], [x - half, half, z]]


def lamp(name, half, z, x=0):
    return {"name": name, "shape": "polygon", "vertices": square(half, z, x)[::-1]}


def polygon(name, vertices):
    return {"name": name, "shape": "polygon", "vertices": vertices}


def scene(lights, blockers, receivers=(("floor", square(9, 0)),)):
    return {"gnomon": 1, "dimension": 3, "lights": lights, "blockers": blockers,
            "receivers": [polygon(name, vertices) for name, vertices in receivers]}


TABLE = polygon("table", square(2, 2))
WALLS = [("floor", square(9, 0)), ("wall", [[-9, 9, 0], [9, 9, 0], [9, 9, 9], [-9, 9, 9]]), ("shelf", square(1, 1, 4))]
WEDGE = "v -1 -1 2\nv 1 -1 2\nv 1 1 2\nv -1 1 3\nf 1 2 3\nf 1 3 4\n"
PLANE = {"gnomon": 1, "dimension": 2,
         "lights": [{"name": "left", "shape": "segment", "vertices": [[-3, 5], [-2, 5]]},
                    {"name": "right", "shape": "segment", "vertices": [[2, 5], [3, 5]]}],
         "blockers": [{"name": "wall", "shape": "segment", "vertices": [[-1, 2], [1, 2]]},
                      {"name": "post", "shape": "segment", "vertices": [[2, 1], [3, 1]]}]}

#: Every kind of page: what is drawn, and how it came to be.
PAGES = {
    "a lamp": (scene([lamp("lamp", 1, 4)], [TABLE]), None, ""),
    "a lamp from above": (scene([lamp("lamp", 1, 4)], [TABLE]), None, "--camera top"),
    "a lamp, walls and a shelf": (scene([lamp("lamp", 1, 4)], [TABLE], WALLS), None, ""),
    "no receiver": (scene([lamp("lamp", 1, 4)], [TABLE], ()), None, ""),
    "two lamps": (scene([lamp("left", 1, 4, -3), lamp("right", 1, 4, 3)], [TABLE]), None, ""),
    "a sun": (scene([{"name": "sun", "shape": "direction", "direction": [1, 0, -2]}], [TABLE]), None, ""),
    "a bulb and a tube": (scene([{"name": "bulb", "shape": "point", "position": [0, 0, 4]},
                                 {"name": "tube", "shape": "segment", "vertices": [[-2, 0, 4], [2, 0, 4]]}], [TABLE]),
                          None, ""),
    "a mesh": (scene([lamp("lamp", 1, 5)], [{"name": "wedge", "shape": "mesh", "file": "wedge.obj"}]), None, ""),
    "a mesh with its volumes": (scene([lamp("lamp", 1, 5)], [{"name": "wedge", "shape": "mesh", "file": "wedge.obj"}]),
                                None, "--volumes"),
    "names that look like markup": (scene([lamp("<!--<script>", 1, 4)], [polygon("<b>&amp;]]>", square(2, 2))]), None, ""),
    "a folder of shadow": (scene([lamp("lamp", 1, 4)], [TABLE]), "shadow", ""),
    "a folder of receivers": (scene([lamp("left", 1, 4, -3), lamp("right", 1, 4, 3)], [TABLE], WALLS), "receivers", ""),
    "a folder of discontinuities": (scene([lamp("lamp", 1, 4)], [TABLE]), "discontinuities", ""),
    "the plane": (PLANE, None, ""),
    "a folder of the plane": (PLANE, "shadow", ""),
}


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory(prefix="gnomon-pages-")
        cls.folder = pathlib.Path(cls.place.name)
        (cls.folder / "wedge.obj").write_text(WEDGE)
        cls.browser = Chromium(CHROMIUM)

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.place.cleanup()

    def tearDown(self):
        self.assertEqual(self.browser.messages, [], "the page's console")

    def gnomon(self, *arguments):
        run = subprocess.run([GNOMON, *arguments, "--quiet"], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)

    def open(self, document, command=None, options=""):
        (self.folder / "a.scene.json").write_text(json.dumps(document))
        drawn = "a.scene.json"
        if command:
            self.gnomon(command, drawn, "--out", "result_of_" + command)
            drawn = "result_of_" + command
        self.gnomon("render", drawn, "--out", "page.html", *options.split())
        self.browser.open(self.folder / "page.html")

    def left(self):
        """The column where the words beside the picture end."""
        return int(self.browser.value("document.getElementById('words').getBoundingClientRect().right")) + 1

    def shown(self):
        """How many pixels of each colour the picture has beside the words."""
        return self.browser.screenshot().histogram(self.left())

    def row(self, text):
        """A CSS selector of the legend's row that begins with a text."""
        rows = self.browser.value("[...document.querySelectorAll('#legend li')].map(row => row.textContent)")
        found = [i for i, row in enumerate(rows) if row.startswith(text)]
        self.assertEqual(len(found), 1, f"{text} among {rows}")
        return f"#legend li:nth-child({found[0] + 1}) button"

    def expect_still_there(self, before, after):
        """Surfaces in space change their shade when they are turned; what lies on receivers does not."""
        inked = [sum(counts.values()) - counts[(255, 255, 255)] for counts in (before, after)]
        self.assertGreater(inked[1], inked[0] / 2, "fills go with the drag")
        for color in (LIT, PENUMBRA, UMBRA):
            if before[color] > 1000:
                self.assertGreater(after[color], 200, f"{color} goes with the drag")

    def test_of_every_kind_keep_their_colours_when_they_are_turned_and_say_nothing(self):
        for name, page in PAGES.items():
            with self.subTest(name):
                self.open(*page)
                before = self.browser.screenshot()
                self.browser.drag((500, 300), (560, 330))
                after = self.browser.screenshot()
                self.assertGreater(after.differing(before, self.left()), 2000, "nothing moves")
                self.expect_still_there(before.histogram(self.left()), after.histogram(self.left()))
                self.browser.click("#reset")
                self.browser.move(5, 595)
                self.assertEqual(self.browser.screenshot().differing(before, self.left()), 0, "reset view")
                self.assertEqual(self.browser.messages, [])

    def test_show_the_same_after_a_quarter_turn_of_a_scene_that_is_the_same_after_one(self):
        self.open(scene([lamp("lamp", 1, 4)], [TABLE]), None, "--no-labels --camera 16,-30,16,0,0,0")
        for row in ("umbra volume", "penumbra volume"):  # which would tint what is on the floor
            self.browser.click(self.row(row))
        self.browser.move(5, 595)
        left = self.left()
        before = self.browser.screenshot()
        self.browser.drag((400, 300), (475, 300))
        eighth = self.browser.screenshot()
        self.browser.drag((400, 300), (475, 300))  # 150 of 600 pixels are a quarter
        self.browser.move(5, 595)
        quarter = self.browser.screenshot()
        self.assertGreater(eighth.differing(before, left), 20000)
        self.assertLess(quarter.differing(before, left), 2000)
        places = [(x, y) for x in range(left + 20, 800, 20) for y in range(20, 600, 20)]
        same = [place for place in places if quarter.at(*place) == before.at(*place)]
        self.assertGreater(len(same), 0.97 * len(places))
        for color in (LIT, PENUMBRA, UMBRA):
            self.assertTrue(any(before.at(*place) == color for place in same), color)

    def test_show_the_arrow_of_a_sun_in_their_corner_wherever_the_scene_lies(self):
        sun = {"name": "sun", "shape": "direction", "direction": [1, 0, -2]}
        for x in (0, 300):
            self.open(scene([sun], [polygon("table", square(2, 2, x))], [("floor", square(9, 0, x))]))
            picture = self.browser.screenshot()
            yellow = [(r, g, b) for y in range(0, 150) for x in range(600, 800) for r, g, b in [picture.at(x, y)]
                      if r > 150 and g > 110 and b < 90]
            self.assertGreater(len(yellow), 300)

    def test_select_no_words_while_they_are_dragged(self):
        self.open(PLANE)
        self.browser.drag((500, 300), (560, 480))
        self.assertEqual(self.browser.value("getSelection().toString()"), "")

    def test_switch_off_what_a_row_of_the_legend_names(self):
        self.open(scene([lamp("lamp", 1, 4)], [TABLE]), None, "--no-labels")
        self.browser.click(self.row("umbra volume"))
        self.browser.click(self.row("penumbra volume"))
        for text, color in (("umbra on", UMBRA), ("penumbra on", PENUMBRA), ("lit on", LIT)):
            self.assertGreater(self.shown()[color], 1000, text)
            self.browser.click(self.row(text))
            self.assertEqual(self.shown()[color], 0, text)
            self.browser.click(self.row(text))
            self.assertGreater(self.shown()[color], 1000, text)

    def test_of_the_plane_switch_off_what_a_row_of_the_legend_names(self):
        self.open(PLANE)
        for text, color in (("umbra", UMBRA), ("penumbra", PENUMBRA), ("lit", LIT), ("blocker", BLOCKER_IN_PLANE)):
            self.assertGreater(self.shown()[color], 300, text)
            self.browser.click(self.row(text))
            self.assertLess(self.shown()[color], 30, text)
            self.browser.click(self.row(text))

    def shares(self, *layers):
        """The shares of the regions of the floor in a picture from above in which all else is switched off."""
        for row in layers:
            self.browser.click(self.row(row))
        self.browser.value("document.getElementById('words').style.visibility = 'hidden'")
        found = self.browser.screenshot().histogram()
        counts = {"lit": found[LIT], "penumbra": found[PENUMBRA], "umbra": found[UMBRA]}
        return {region: count / sum(counts.values()) for region, count in counts.items()}

    def expect_exact_shares(self, shares, light):
        """The borders between regions have pixels of their own, so one in a hundred is what a picture can tell."""
        self.gnomon("receivers", "a.scene.json", "--light", light, "--json", "areas.json")
        (receiver,) = json.loads((self.folder / "areas.json").read_text())["receivers"]
        for region, share in shares.items():
            self.assertAlmostEqual(share, receiver["areas"][region]["double"] / receiver["area"], delta=0.01, msg=region)

    def test_colour_receivers_by_the_exact_regions_of_all_blockers_together(self):
        tiles = [polygon(f"tile {i}", [[x, y, 2], [x + 1, y, 2], [x + 1, y + 1, 2], [x, y + 1, 2]])
                 for i, (x, y) in enumerate((x, y) for x in range(-2, 2) for y in range(-2, 2))]
        self.open(scene([lamp("lamp", 1, 4)], tiles), None, "--camera top --no-labels")
        shares = self.shares("light", "blockers", "penumbra volume", "umbra volume")
        self.assertAlmostEqual(shares["umbra"], 1 / 9, delta=0.01)
        self.expect_exact_shares(shares, "lamp")

    def test_colour_receivers_by_irradiance_with_a_scale_for_each_light(self):
        suns = [{"name": name, "shape": "direction", "direction": [0, 0, -1], "irradiance": e}
                for name, e in (("sun", 5), ("moon", 2))]
        self.open(scene(suns, [TABLE]), None, "--colour irradiance --camera top")
        before = self.shown()
        self.assertGreater(before[FULL], 5000)
        self.assertEqual(before[LIT], 0)
        self.browser.click(self.row("irradiance 5 W/m²"))
        self.assertEqual(self.shown()[FULL], 0)
        pressed = "[...document.querySelectorAll('#legend button')].filter(b => b.textContent.endsWith('W/m²'))" \
                  ".map(b => b.getAttribute('aria-pressed')).join()"
        self.assertNotIn("true", self.browser.value(pressed), "all rows of the scale tell that it is off")
        self.browser.click(self.row("irradiance 5 W/m²"))
        self.browser.key("l")
        self.assertGreater(self.shown()[FULL], before[FULL] / 2, "the moon has a scale of its own")

    def test_colour_receivers_by_one_light_at_a_time(self):
        lamps = [lamp("lamp", 1, 4), lamp("lamp2", 1, 4, 3)]
        self.open(scene(lamps, [polygon("table", square(1, 2))]), None, "--camera top --no-labels")
        shares = self.shares("light (lamp)", "blocker", "penumbra volume", "umbra volume")
        self.expect_exact_shares(shares, "lamp")
        self.browser.key("l")
        self.expect_exact_shares(self.shares(), "lamp2")

    def test_let_their_reader_choose_one_light_at_a_time(self):
        for document in (scene([lamp("left", 1, 4, -3), lamp("right", 1, 4, 3)], [TABLE]), PLANE):
            with self.subTest(document["dimension"]):
                self.open(document, None, "--no-labels")
                left = self.browser.screenshot()
                self.assertEqual(self.browser.value("document.querySelector('#legend li:not([hidden])').textContent"),
                                 "light (left), one of 2")
                self.browser.click("#lights label:nth-of-type(2)")
                right = self.browser.screenshot()
                self.assertGreater(right.differing(left, self.left()), 5000)
                self.assertEqual(self.browser.value("document.querySelector('#legend li:not([hidden])').textContent"),
                                 "light (right), one of 2")
                self.browser.key("l")
                self.browser.move(5, 595)
                self.assertEqual(self.browser.screenshot().differing(left, self.left()), 0)

    def test_turn_grow_and_come_back_by_keys(self):
        for document in (scene([lamp("lamp", 1, 4)], [TABLE]), PLANE):
            self.open(document)
            before = self.browser.screenshot()
            for key in ("ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "+", "-"):
                with self.subTest(f"{document['dimension']} {key}"):
                    self.browser.key(key)
                    self.assertGreater(self.browser.screenshot().differing(before, self.left()), 1000)
                    self.browser.key("r")
                    self.assertEqual(self.browser.screenshot().differing(before, self.left()), 0)

    def test_name_what_lies_under_the_pointer(self):
        self.open(scene([lamp("lamp", 1, 4)], [TABLE]))
        found = set()
        for x in range(300, 780, 40):
            for y in range(100, 560, 30):
                self.browser.move(x, y)
                found.update(self.browser.value("document.getElementById('tip').textContent").split("\n"))
        for name in ("umbra of table, lamp: supporting plane: edge", "penumbra of table, lamp: separating plane: edge",
                     "lit on floor", "table"):
            self.assertTrue(any(text.startswith(name) for text in found), f"{name} in {found}")

    def test_leave_out_labels_that_are_hidden(self):
        """From below the floor hides what stands on it, and its own name."""
        shown = "[...document.querySelectorAll('.label')].filter(l => l.style.display !== 'none').map(l => l.textContent)"
        shelf = polygon("shelf", square(0.5, 1))
        self.open(scene([lamp("lamp", 1, 4)], [TABLE, shelf]), None, "--camera top")
        self.assertEqual(sorted(self.browser.value(shown)), ["floor", "lamp", "table"])
        self.open(scene([lamp("lamp", 1, 4)], [TABLE, shelf]), None, "--camera front")
        self.assertIn("shelf", self.browser.value(shown))

    def test_of_the_cornell_box_are_smaller_than_five_megabytes(self):
        self.gnomon("render", os.path.join(EXAMPLES, "cornell_box.scene.json"), "--out", "page.html")
        self.assertLess((self.folder / "page.html").stat().st_size, 5_000_000)
        self.browser.open(self.folder / "page.html")
        self.assertGreater(len(self.shown()), 100)


if __name__ == "__main__":
    unittest.main(verbosity=2)
