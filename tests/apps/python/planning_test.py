"""View factors, placed lights, illumination meshes, partitions and theorems are those of the program."""

import csv
import io
import json
import threading
import time
from fractions import Fraction

import numpy as np
import pytest

import gnomon
from conftest import EXAMPLES, run_program


def test_view_factors_are_those_of_the_program():
    file = EXAMPLES / "shapiro.scene.json"
    found = gnomon.Scene.read(file).view_factors(bound=1e-6)
    rows = list(csv.DictReader(io.StringIO(run_program("view-factors", str(file), "--bound", "1e-6", "--quiet"))))
    names = np.array(found.surfaces)
    assert names[found.source()].tolist() == [row["from"] for row in rows]
    assert names[found.target()].tolist() == [row["to"] for row in rows]
    assert found.factor().tolist() == [float(row["factor"]) for row in rows]
    assert found.areas()[found.source()].tolist() == [float(row["area"]) for row in rows]
    assert ["proven" if proven else "estimate" for proven in found.is_proven()] == [row["bound_is"] for row in rows]
    printed = np.array([float(row["error_bound"]) for row in rows])
    assert np.all(printed >= found.error_bound()) and np.allclose(printed, found.error_bound(), rtol=1e-9, atol=1e-16)


def test_factors_of_a_closed_room_add_up_to_one():
    room = gnomon.Scene()
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], dtype=float)
    walls = {"a": [0, 1, 3, 2], "b": [4, 6, 7, 5], "c": [0, 4, 5, 1], "d": [2, 3, 7, 6], "e": [0, 2, 6, 4], "f": [1, 5, 7, 3]}
    for name, wall in walls.items():
        room.add_receiver(name, corners[wall[::-1]])
    values, bounds = room.view_factors().matrix()
    assert values.shape == (6, 6) and not values.diagonal().any()
    assert np.all(np.abs(values.sum(axis=1) - 1) <= bounds.sum(axis=1))
    assert values[0, 1] == pytest.approx(0.19982489569838746, abs=1e-12)
    one = room.view_factors(source="c")
    assert set(one.source().tolist()) == {2}
    with pytest.raises(gnomon.ArgumentError, match="source: found no surface 'g', expected one of 'a', 'b'"):
        room.view_factors(source="g")
    with pytest.raises(gnomon.ArgumentError, match="bound: expected a number larger than 0"):
        room.view_factors(bound=0)


@pytest.mark.parametrize("goals", ["desk", "desk_conflict", "desk_ceiling", "desk_bright"])
def test_placed_lights_are_those_of_the_program(goals):
    scene_file, goals_file = EXAMPLES / "desk.scene.json", EXAMPLES / f"{goals}.goals.json"
    told = json.loads(run_program("place", str(scene_file), "--goals", str(goals_file), "--json", "-", "--quiet"))
    scene = gnomon.Scene.read(scene_file)
    assert scene.place(goals_file) == told
    assert scene.place(str(goals_file)) == told
    assert scene.place(json.loads(goals_file.read_text())) == told


def test_places_are_checked_and_chosen():
    scene = gnomon.Scene.read(EXAMPLES / "desk.scene.json")
    goals = json.loads((EXAMPLES / "desk.goals.json").read_text())
    assert scene.place(goals)["answer"]["exact"] == ["15/2", "3", "24"]
    assert scene.place(goals, check=[7, 3, 24])["checked"]
    assert scene.place(goals, choose="nearest", near=np.array([0, 3, 24]))["status"] == "feasible"
    for wrong in ({"choose": "best"}, {"choose": "nearest"}, {"near": [0, 0, 0]}, {"check": [1, 2]}):
        with pytest.raises(gnomon.ArgumentError):
            scene.place(goals, **wrong)
    with pytest.raises(gnomon.SceneError, match="goals: /goals/0/want"):
        scene.place({**goals, "goals": [{"name": "a", "at": [0, 0, 0], "want": "warm"}]})
    with pytest.raises(gnomon.SceneError, match="found no such file"):
        scene.place("nowhere.goals.json")


def test_illumination_is_that_of_the_program():
    file = EXAMPLES / "figure_4_22.scene.json"
    told = json.loads(run_program("illuminate", str(file), "--relative", "0.2", "--json", "-", "--quiet"))["receivers"][0]
    (floor,) = gnomon.Scene.read(file).illuminate(relative=0.2)
    assert floor.name == told["name"] and floor.lights == ("lamp",)
    assert len(floor.faces()) == told["faces"] and len(floor.points()) == told["points"]
    assert floor.flux() == (told["flux"]["value"], told["flux"]["error"])
    assert floor.face_error().max() == told["largest_error"]
    assert floor.irradiance().max() == told["largest"]["irradiance"]
    assert floor.unmet_faces() == 0


def test_quadratic_faces_have_middles():
    scene = gnomon.Scene.read(EXAMPLES / "figure_4_22.scene.json")
    (floor,) = scene.illuminate(tolerance=0.05, order=2)
    points, faces = floor.points(), floor.faces()
    assert faces.shape[1] == 6
    assert np.allclose(points[faces[:, 3]], (points[faces[:, 0]] + points[faces[:, 1]]) / 2)
    for wrong in ({"order": 3}, {"tolerance": 0}, {"relative": -1}, {"split": "some"}, {"receiver": "x"}, {"light": "x"}):
        with pytest.raises(gnomon.ArgumentError):
            scene.illuminate(**wrong)


@pytest.mark.parametrize("name", ["figure_4_16", "figure_4_21"])
def test_partitions_are_those_of_the_program(name):
    file = EXAMPLES / f"{name}.scene.json"
    scene = gnomon.Scene.read(file)
    for told in json.loads(run_program("shadow", str(file), "--json", "-", "--quiet"))["lights"]:
        found = scene.partition(told["light"])
        assert len(found.edges()) == told["boundary_edges"]
        for region in (gnomon.Region.LIT, gnomon.Region.PENUMBRA, gnomon.Region.UMBRA):
            of_region = told[region.name.lower()]
            assert found.exact_areas()[region] == Fraction(of_region["exact"])
            assert found.areas()[region] == of_region["area_in_box"]
            assert np.count_nonzero(found.face_regions() == region) == of_region["components"]
        assert sum(found.exact_face_areas()) == sum(found.exact_areas().values())


def test_a_partition_of_a_box_is_in_triangles_and_knows_both_sides_of_edges():
    scene = gnomon.Scene(2)
    scene.add_light("tube", [[-1, 4], [1, 4]])
    scene.add_blocker("wall", [[-1, 2], [1, 2]])
    found = scene.partition(box=[[-8, -8], [8, 8]])
    assert sum(found.exact_areas().values()) == 256
    points, triangles, faces = found.triangles()
    a, b, c = (points[triangles[:, k]] for k in range(3))
    doubled = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    assert np.all(doubled > 0) and doubled.sum() == 512
    middles = (a + b + c) / 3
    assert np.array_equal(scene.regions(middles).region[:, 0], found.face_regions()[faces])
    assert found.edge_faces().shape == found.edges().shape and found.edge_faces().max() == len(found.face_regions()) - 1
    assert len(scene.partition(structure=True, box=[[-8, -8], [8, 8]]).face_regions()) >= len(found.face_regions())
    with pytest.raises(gnomon.ArgumentError, match="box: found no two corners"):
        scene.partition(box=[[0, 0], [0, 1]])
    scene.add_light("bulb", position=[0, 9])
    with pytest.raises(gnomon.ArgumentError, match="light: the scene has 2 lights, expected the name of one"):
        scene.partition()
    with pytest.raises(gnomon.UnsupportedError, match="a partition needs a scene of dimension 2"):
        gnomon.Scene().partition()


def test_theorems_hold_and_false_claims_are_refuted():
    found = gnomon.theorems(only=["S4", "F1"], cases=20, seed=3)
    assert found["seed"] == 3
    assert [(s["key"], s["status"], s["cases"]) for s in found["statements"]] == [("S4", "holds", 20), ("F1", "refuted", 20)]
    with pytest.raises(gnomon.ArgumentError, match="^only: there is no statement 'XX'"):
        gnomon.theorems(only=["XX"])


def test_long_work_leaves_the_interpreter_to_others():
    scene = gnomon.Scene.read(EXAMPLES / "cornell_box.scene.json")
    points = np.random.default_rng(41).uniform(0, 500, (200_000, 3))
    working = threading.Thread(target=lambda: scene.irradiance(points, np.ones_like(points), threads=1))
    working.start()
    turns = 0
    while working.is_alive():
        turns += 1
        time.sleep(0.001)
    assert turns > 10
