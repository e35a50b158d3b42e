"""Pairs are those of the program: planes by name and number, volumes, sides of points."""

import json
from fractions import Fraction

import numpy as np
import pytest

import gnomon
from conftest import EXAMPLES, run_program


@pytest.mark.parametrize("name", ["figure_4_22", "figure_4_23", "figure_4_24_a", "two_lamps", "cornell_box", "boxes"])
def test_pairs_are_those_of_the_program(name):
    file = EXAMPLES / f"{name}.scene.json"
    scene = gnomon.Scene.read(file)
    document = json.loads(run_program("shadow", str(file), "--json", "-", "--quiet"))
    for told in document["pairs"]:
        pair = scene.pair(told["light"], told["blocker"])
        assert pair.position == told["position"]
        assert len(pair.planes()) == len(told["planes"])
        for plane, plane_told in zip(pair.planes(), told["planes"]):
            assert plane.edge == plane_told["edge"]["index"] and plane.vertex == plane_told["vertex"]["index"]
            assert plane.kind == f"{plane_told['contact']}_{plane_told['edge']['of']}_plane"
            assert list(plane.coefficients or []) == plane_told.get("coefficients", [])
            assert list(plane.exact or []) == [Fraction(text) for text in plane_told.get("exact", [])]
        for volume in ("occlusion", "umbra", "penumbra"):
            facts = pair.facts(volume)
            assert {key: facts[key] for key in facts} == {key: told[volume][key] for key in facts}
        for volume in ("occlusion", "umbra", "penumbra"):
            assert pair.volume(volume).volume == told[volume]["volume_in_box"]


def test_a_volume_is_a_closed_surface_around_its_exact_measure(lamp_and_table):
    scene = gnomon.Scene()
    scene.add_light("lamp", [[-2, -2, 4], [-2, 2, 4], [2, 2, 4], [2, -2, 4]])
    scene.add_blocker("board", [[-1, -1, 3], [1, -1, 3], [1, 1, 3], [-1, 1, 3]])
    pair = scene.pair("lamp", "board")
    umbra = pair.volume("umbra", [[-9, -9, 0], [9, 9, 9]])
    assert umbra.exact_volume == Fraction(4, 3) and umbra.volume == 4 / 3 and not umbra.truncated
    assert umbra.triangles.shape == (6, 3) and umbra.vertices.shape == (5, 3)
    assert [0, 0, 2] in umbra.vertices.tolist()
    edges = {tuple(t[[k, (k + 1) % 3]]) for t in umbra.triangles for k in range(3)}
    assert len(edges) == 18 and {(b, a) for a, b in edges} == edges
    assert {umbra.facets[f][0] for f in umbra.triangle_facets} == {"blocker_face", "supporting_blocker_plane"}
    penumbra, occlusion = pair.volume("penumbra", [[-9, -9, 0], [9, 9, 9]]), pair.volume("occlusion", [[-9, -9, 0], [9, 9, 9]])
    assert umbra.exact_volume + penumbra.exact_volume == occlusion.exact_volume


def test_sides_of_points_are_decided_exactly():
    scene = gnomon.Scene()
    scene.add_light("lamp", [[-2, -2, 4], [-2, 2, 4], [2, 2, 4], [2, -2, 4]])
    scene.add_blocker("board", [[-1, -1, 3], [1, -1, 3], [1, 1, 3], [-1, 1, 3]])
    pair = scene.pair("lamp", "board")
    above, below = np.nextafter(2, 3), np.nextafter(2, 1)
    assert pair.sides([[0, 0, above], [0, 0, 2], [0, 0, below]]).tolist() == [-1, 0, 1]
    assert pair.sides([[0, 0, below], [99, 0, 0]], "occlusion").tolist() == [-1, 1]
    assert pair.sides(np.zeros((0, 3))).shape == (0,)


def test_sides_agree_with_planes_in_fractions():
    """The oracle is the definition: a x + b y + c z + d of every plane, in rational arithmetic."""
    scene = gnomon.Scene.read(EXAMPLES / "figure_4_22.scene.json")
    pair = scene.pair("lamp", "board")
    print("seed 31")
    points = np.random.default_rng(31).integers(-8, 9, (200, 3)) / 4
    kinds = {"umbra": "supporting", "occlusion": "separating"}
    for volume, contact in kinds.items():
        planes = [p.exact for p in pair.planes() if p.kind.startswith(contact)]
        assert None not in planes
        sides = pair.sides(points, volume)
        for point, side in zip(points.tolist(), sides):
            x, y, z = map(Fraction, point)
            most = max(a * x + b * y + c * z + d for a, b, c, d in planes)
            most = max(most, z - Fraction(9, 4))  # the board's own plane
            assert side == (most > 0) - (most < 0)


def test_parts_are_pairs_of_their_own(tmp_path):
    scene = gnomon.Scene()
    scene.add_light("bulb", position=[0, 0, 9])
    scene.add_blocker("angle", [[0, 0, 1], [2, 0, 1], [2, 1, 1], [1, 1, 1], [1, 2, 1], [0, 2, 1]], shape="concave_polygon")
    with pytest.raises(gnomon.ArgumentError, match="found 2 pairs of convex parts, expected one, as of 'bulb' and 'angle#1'"):
        scene.pair("bulb", "angle")
    assert scene.pair("bulb", "angle#1").blocker == "angle#1"
    assert repr(scene.pair("bulb", "angle#0")) == "<gnomon.Pair 'bulb', 'angle#0'>"


@pytest.mark.parametrize(
    ("ask", "sentence"),
    [
        (lambda s: s.pair("sun", "table"), "light: the scene has no light 'sun'; it has 'lamp'"),
        (lambda s: s.pair("lamp", "chair"), "blocker: the scene has no blocker 'chair'; it has 'table'"),
        (lambda s: s.pair("lamp", "table#7"), "blocker: found 'table#7', which has no such part"),
        (lambda s: s.pair("lamp", "table").volume("light"), "volume: found 'light', expected 'occlusion', 'umbra' or"),
        (lambda s: s.pair("lamp", "table").sides([[0, 0, 0]], "penumbra"), "expected 'occlusion' or 'umbra'"),
        (lambda s: s.pair("lamp", "table").facts(""), "volume: found ''"),
        (lambda s: s.pair("lamp", "table").volume("umbra", [[0, 0, 0], [1, 1, 0]]), "box: found no two corners"),
        (lambda s: s.pair("lamp", "table").volume("umbra", [[0, 0, 0]]), "box: found no two corners"),
    ],
)
def test_what_makes_no_sense_is_refused(lamp_and_table, ask, sentence):
    with pytest.raises(gnomon.ArgumentError) as refusal:
        ask(lamp_and_table)
    assert sentence in str(refusal.value)


def test_a_pair_without_volumes_is_refused_as_the_program_refuses_it():
    scene = gnomon.Scene()
    scene.add_light("bent", [[0, 0, 4], [0, 1, 4], [1, 1, 4 + 1e-12], [1, 0, 4]])
    scene.add_blocker("wall", [[0, 0, 3], [0, 1, 3], [0, 1, 5], [0, 0, 5]])
    with pytest.raises(gnomon.UnsupportedError, match="light 'bent', blocker 'wall': "):
        scene.pair("bent", "wall")
    with pytest.raises(gnomon.UnsupportedError, match="a pair in scenes of dimension 2 is not available"):
        gnomon.Scene.read(EXAMPLES / "figure_4_17.scene.json").pair("light", "a")
