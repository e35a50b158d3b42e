"""Looks at the pixels of `gnomon render`: GNOMON=PROGRAM png_test.py"""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from pixels import Pixels

GNOMON = os.environ["GNOMON"]

LIT, PENUMBRA, UMBRA = (255, 247, 219), (120, 181, 227), (18, 56, 107)
FULL, NOTHING = (251, 244, 136), (35, 19, 77)  # the ends of the scale of irradiance
LAMP = {"name": "lamp", "shape": "polygon", "vertices": [[-6, -1, 4], [-6, 1, 4], [-4, 1, 5], [-4, -1, 5]]}
LAMP2 = {"name": "lamp2", "shape": "polygon", "vertices": [[4, -1, 5], [4, 1, 5], [6, 1, 4], [6, -1, 4]]}
TILES = [{"name": f"tile {x} {y}", "shape": "polygon",
          "vertices": [[x, y, 2], [x + 1, y, 2], [x + 1, y + 1, 2], [x, y + 1, 2]]}
         for x in range(-1, 1) for y in range(-1, 1)]
FLOOR = {"name": "floor", "shape": "polygon", "vertices": [[-12, -9, 0], [12, -9, 0], [12, 9, 0], [-12, 9, 0]]}
WALL = {"name": "wall", "shape": "polygon", "vertices": [[-12, 9, 0], [12, 9, 0], [12, 9, 6], [-12, 9, 6]]}
ROOF = "v -1 -1 2\nv 1 -1 2\nv 1 1 2\nv -1 1 2\nv 0 0 2.5\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n"


class Pictures(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory(prefix="gnomon-pictures-")
        self.folder = pathlib.Path(self.place.name)
        (self.folder / "roof.obj").write_text(ROOF)

    def tearDown(self):
        self.place.cleanup()

    def gnomon(self, *arguments):
        run = subprocess.run([GNOMON, *arguments], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stderr)
        return run

    def write(self, lights, blockers, receivers=(FLOOR,)):
        document = {"gnomon": 1, "dimension": 3, "lights": lights, "blockers": blockers, "receivers": list(receivers)}
        (self.folder / "a.scene.json").write_text(json.dumps(document))

    def picture(self, drawn, *options):
        self.gnomon("render", drawn, "--out", "a.png", "--size", "640x480", "--no-labels", "--no-legend", *options)
        return Pixels((self.folder / "a.png").read_bytes())

    def expect_ratio(self, picture, light, receiver="floor"):
        """Umbra and penumbra are as large beside each other as `receivers` says: seen from above nothing hides them."""
        self.gnomon("receivers", "a.scene.json", "--light", light, "--receiver", receiver, "--json", "areas.json")
        areas = json.loads((self.folder / "areas.json").read_text())["receivers"][0]["areas"]
        found = picture.histogram()
        self.assertGreater(found[UMBRA], 100)
        self.assertAlmostEqual(found[UMBRA] / found[PENUMBRA], areas["umbra"]["double"] / areas["penumbra"]["double"],
                               delta=0.05)

    def test_of_every_size_show_the_umbra_behind_the_penumbra(self):
        """The walls of the umbra, seen through one of the penumbra and before another, in the colour they have then."""
        lamp = {"name": "lamp", "shape": "polygon",
                "vertices": [[-0.5523029120714642, -0.13640534527590453, 2.6445354095025193],
                             [-0.5523029120714642, 0.3778950351453628, 2.9535582544485517],
                             [0.5523029120714642, 0.13640534527590453, 3.3554645904974807],
                             [0.5523029120714642, -0.3778950351453628, 3.0464417455514483]]}
        board = {"name": "b", "shape": "polygon",
                 "vertices": [[-0.5, -0.5, 1], [0.5, -0.5, 1], [0.5, 0.5, 1], [-0.5, 0.5, 1]]}
        floor = {"name": "floor", "shape": "polygon", "vertices": [[-4, -4, 0], [4, -4, 0], [4, 4, 0], [-4, 4, 0]]}
        self.write([lamp], [board], [floor])
        for size in ("1024x768", "1280x960"):
            self.gnomon("render", "a.scene.json", "--out", "a.png", "--size", size)
            found = Pixels((self.folder / "a.png").read_bytes()).histogram()
            wall = sum(count for color, count in found.items()
                       if max(abs(c - w) for c, w in zip(color, (75, 109, 141))) < 12)
            self.assertGreater(wall, 2000, size)

    def test_of_a_mesh_colour_its_receiver_by_all_facets_together(self):
        self.write([LAMP], [{"name": "roof", "shape": "mesh", "file": "roof.obj"}])
        self.expect_ratio(self.picture("a.scene.json", "--camera", "top"), "lamp")

    def test_colour_receivers_by_irradiance_on_its_scale(self):
        """A sun of 5 W/m^2 from above: what is lit has the end of the scale, the shadow its beginning."""
        sun = {"name": "sun", "shape": "direction", "direction": [0, 0, -1], "irradiance": 5}
        shelf = {"name": "shelf", "shape": "polygon", "vertices": [[20, 0, 2], [26, 0, 2], [26, 6, 2], [20, 6, 2]]}
        floor = {"name": "floor", "shape": "polygon", "vertices": [[0, -9, 0], [40, -9, 0], [40, 9, 0], [0, 9, 0]]}
        self.write([sun], [shelf], [floor])
        seen_from_below = self.picture("a.scene.json", "--colour", "irradiance", "--camera", "60,0,60,20,0,0").histogram()
        self.assertGreater(seen_from_below[FULL], 20 * seen_from_below[NOTHING])
        self.assertGreater(seen_from_below[NOTHING], 300)
        self.assertEqual(seen_from_below[LIT], 0)

    def test_of_a_folder_of_receivers_show_the_light_asked_for(self):
        self.write([LAMP, LAMP2], TILES)
        self.gnomon("receivers", "a.scene.json", "--out", "divided")
        first = self.picture("divided", "--camera", "top")
        self.expect_ratio(first, "lamp")
        second = self.picture("divided", "--camera", "top", "--light", "lamp2")
        self.expect_ratio(second, "lamp2")
        self.assertGreater(second.differing(first), 5000)
        self.assertEqual(self.picture("divided", "--camera", "top", "--light", "lamp").differing(first), 0)

    def test_of_a_folder_of_shadow_are_those_of_its_scene(self):
        self.write([LAMP, LAMP2], TILES, [FLOOR, WALL])
        self.gnomon("shadow", "a.scene.json", "--out", "shadow")
        for options in ((), ("--light", "lamp2"), ("--receiver", "wall"), ("--up", "y")):
            with self.subTest(options):
                self.assertEqual(self.picture("shadow", *options).differing(self.picture("a.scene.json", *options)), 0)

    def test_draw_one_receiver_where_one_is_asked_for(self):
        self.write([LAMP], [{"name": "roof", "shape": "mesh", "file": "roof.obj"}], [FLOOR, WALL])
        both = self.picture("a.scene.json").histogram()
        one = self.picture("a.scene.json", "--receiver", "wall").histogram()
        self.assertGreater(both[UMBRA], 50)
        self.assertEqual(one[UMBRA], 0)

    def test_do_not_draw_lights_that_are_not_asked_for(self):
        self.write([LAMP, LAMP2], TILES)
        alone = self.picture("a.scene.json", "--camera", "30,-30,20,0,0,0")
        self.write([LAMP], TILES)
        self.assertEqual(self.picture("a.scene.json", "--camera", "30,-30,20,0,0,0").differing(alone), 0)

    def test_draw_volumes_of_a_mesh_only_when_they_are_asked_for(self):
        self.write([LAMP], [{"name": "roof", "shape": "mesh", "file": "roof.obj"}])
        without = self.picture("a.scene.json")
        self.assertGreater(self.picture("a.scene.json", "--volumes").differing(without), 3000)


if __name__ == "__main__":
    unittest.main(verbosity=2)
