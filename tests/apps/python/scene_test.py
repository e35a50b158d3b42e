"""Scenes come from files, dictionaries and arrays, and say in a sentence what is wrong with them."""

import json
import subprocess

import numpy as np
import pytest

import gnomon
from conftest import EXAMPLES, PROGRAM

CUBE = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (1, 2)], dtype=float)
CUBE_TRIANGLES = np.array(
    [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]
)


@pytest.mark.parametrize("file", sorted(EXAMPLES.glob("**/*.scene.json")), ids=lambda file: file.stem)
def test_a_scene_of_a_file_is_that_of_its_dictionary(file):
    scene = gnomon.Scene.read(file)
    document = scene.to_dict()
    assert document == json.loads(file.read_text())
    again = gnomon.Scene.from_dict(document, folder=file.parent)
    assert again.to_dict() == document
    assert (again.light_names, again.blocker_names) == (scene.light_names, scene.blocker_names)
    assert again.receiver_names == scene.receiver_names
    assert (again.dimension, again.length_unit, again.doubts) == (scene.dimension, scene.length_unit, scene.doubts)


def test_a_scene_of_arrays_is_that_of_its_file(lamp_and_table, tmp_path):
    file = tmp_path / "same.scene.json"
    file.write_text(json.dumps(lamp_and_table.to_dict()))
    again = gnomon.Scene.read(file)
    points = np.random.default_rng(3).uniform(-3, 3, (50, 3))
    assert np.array_equal(again.regions(points).visible_fraction, lamp_and_table.regions(points).visible_fraction)
    assert repr(again) == "<gnomon.Scene of dimension 3: 1 lights, 1 blockers, 1 receivers>"


def test_doubles_come_through_to_the_last_bit():
    scene = gnomon.Scene()
    corners = [[0.1, 1 / 3, 5e-324], [1e300, 0.1, 0], [0.7, 1e16 + 2, 0]]
    scene.add_blocker("odd", corners)
    assert scene.to_dict()["blockers"][0]["vertices"] == corners


def test_a_mesh_of_arrays_is_the_mesh_of_a_file(tmp_path):
    (tmp_path / "cube.off").write_text(
        f"OFF\n{len(CUBE)} {len(CUBE_TRIANGLES)} 0\n"
        + "".join(" ".join(map(repr, v)) + "\n" for v in CUBE.tolist())
        + "".join("3 " + " ".join(map(str, f)) + "\n" for f in CUBE_TRIANGLES.tolist())
    )
    of_file, of_arrays = gnomon.Scene(), gnomon.Scene()
    of_arrays.add_light("bulb", position=[0.5, 0.5, 4])
    of_arrays.add_blocker("cube", CUBE, CUBE_TRIANGLES)
    of_file = gnomon.Scene.from_dict(
        {"gnomon": 1, "dimension": 3, "lights": [{"name": "bulb", "shape": "point", "position": np.array([0.5, 0.5, 4])}],
         "blockers": [{"name": "cube", "shape": "mesh", "file": "cube.off"}]}, folder=tmp_path
    )
    assert of_arrays.doubts == of_file.doubts == ()
    points = np.random.default_rng(5).uniform(-1, 2, (500, 3))
    assert np.array_equal(of_arrays.regions(points).region, of_file.regions(points).region)
    assert set(of_arrays.regions(points).region.ravel().tolist()) == {0, 2}


def test_facets_may_be_polygons_of_any_length():
    scene = gnomon.Scene()
    scene.add_light("glow", CUBE, [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]], radiance=2)
    assert scene.irradiance([[0.5, 0.5, 0]], [[0, 0, 1]]).irradiance[0, 0] > 0


@pytest.mark.parametrize(
    ("facets", "sentence"),
    [
        ([[0, 1, 8]], 'blocker "cube": found the number 8; expected the index of a vertex, from 0 to 7'),
        ([[0, 1, 2.5]], 'blocker "cube": found the number 2.5; expected the index of a vertex, from 0 to 7'),
        ([[0, 1, -1]], 'blocker "cube": found the number -1; expected the index of a vertex, from 0 to 7'),
        ([], "no facet with an area"),
        ([[0, 1]], "no facet with an area"),
        ([[0, 7, 1, 6]], "facet 0"),
        ("round", 'found the string "round"; expected an array of facets, lists of indices of vertices'),
    ],
)
def test_facets_that_make_no_sense_are_refused_by_their_place(facets, sentence):
    scene = gnomon.Scene()
    with pytest.raises(gnomon.SceneError) as refusal:
        scene.add_blocker("cube", CUBE, facets)
    assert sentence in str(refusal.value)
    assert scene.blocker_names == ()


def test_a_mesh_is_either_a_file_or_stands_in_the_scene():
    for keys in ({"file": "cube.off"}, {"usemtl": "wood"}, {"normals": "file"}):
        with pytest.raises(gnomon.SceneError):
            gnomon.Scene().add_blocker("cube", CUBE, CUBE_TRIANGLES, **keys)


@pytest.mark.parametrize(
    ("add", "sentence"),
    [
        (lambda s: s.add_light("lamp", position=[0, 0, 1]), 'add_light: "lamp": found a name that an earlier element'),
        (lambda s: s.add_light("", position=[0, 0, 1]), "expected a name"),
        (lambda s: s.add_light("a", position=[0, 0, 1], intensity=-1), "expected a number, 0 or more"),
        (lambda s: s.add_light("a", position=[0, 0, 1], watts=1), 'found the unknown key "watts"'),
        (lambda s: s.add_light("a", direction=[0, 0, 0]), "found the zero vector; expected a direction"),
        (lambda s: s.add_light("a", [[0, 0, 0], [0, 0, 0]]), "which repeats vertex 0"),
        (lambda s: s.add_light("a"), 'light "a": found no such key; expected an array of points'),
        (lambda s: s.add_blocker("a", [[0, 0, 0], [1, 0, 0], [0, 1, 0]], material="wood"), 'expected the name of one of'),
        (lambda s: s.add_blocker("a", [[0, 0], [1, 0], [0, 1]]), "expected a point of 3 coordinates"),
        (lambda s: s.add_blocker("a", [[0, 0, 0], [1, 1, 1], [2, 2, 2]]), "line"),
        (lambda s: s.add_blocker("a", shape="mesh", file="nowhere.off"), "no such file"),
        (lambda s: s.add_receiver("a", [[0, 0, 0], [1, 0, 0], [0, 1, 0]], shape="ball"), "expected a shape among"),
    ],
)
def test_an_element_that_makes_no_sense_is_refused_and_not_added(lamp_and_table, add, sentence):
    before = lamp_and_table.to_dict()
    with pytest.raises(gnomon.SceneError) as refusal:
        add(lamp_and_table)
    assert sentence in str(refusal.value)
    assert lamp_and_table.to_dict() == before


def test_numbers_that_no_scene_holds_are_refused_by_their_place():
    scene = gnomon.Scene()
    with pytest.raises(gnomon.ArgumentError, match="vertices/1/2: found nan, expected a finite number"):
        scene.add_blocker("a", [[0, 0, 0], [1, 0, float("nan")], [0, 1, 0]])
    with pytest.raises(gnomon.ArgumentError, match="color: found <class 'object'>, expected numbers"):
        scene.add_light("a", position=[0, 0, 1], color=object())
    with pytest.raises(gnomon.ArgumentError, match="lights/0: found the key 5, expected a string"):
        gnomon.Scene.from_dict({"lights": [{5: 1}]})
    with pytest.raises(gnomon.ArgumentError, match="found an integer that no double holds"):
        scene.add_light("a", position=[0, 0, 10**400])


def test_a_bad_file_gets_the_sentence_of_the_program(tmp_path):
    for text in ["", "{", "[]", '{"gnomon": 2}', '{"gnomon": 1, "dimension": 3, "lights": [5], "blockers": []}', "\xff"]:
        file = tmp_path / "bad.scene.json"
        file.write_bytes(text.encode("latin1"))
        run = subprocess.run([PROGRAM, "check", str(file)], capture_output=True, text=True, check=False)
        with pytest.raises(gnomon.SceneError) as refusal:
            gnomon.Scene.read(file)
        assert run.stderr.strip().endswith(str(refusal.value)), text
    with pytest.raises(gnomon.SceneError, match="nowhere.json: found no such file; expected a scene file"):
        gnomon.Scene.read("nowhere.json")


def test_doubts_are_warned_of_in_the_words_of_the_program(tmp_path):
    file = tmp_path / "doubtful.scene.json"
    file.write_text(json.dumps({"gnomon": 1, "dimension": 3, "lights": [{"name": "bulb", "shape": "point", "position": [0, 0, 1]}],
                                "blockers": [], "receivers": [{"name": f"r{k}", "shape": "polygon", "vertices": [[0, 0, 0], [0, 1, 0], [1, 0, 0]]}
                                                              for k in range(12)]}))
    with pytest.warns(gnomon.SceneWarning) as warned:
        scene = gnomon.Scene.read(file)
    run = subprocess.run([PROGRAM, "irradiance", str(file), "--at", "-"], input="0,0,0,0,0,1", capture_output=True, text=True, check=False)
    printed = [line.removeprefix("gnomon: warning: ") for line in run.stderr.splitlines()]
    assert len(scene.doubts) == 13
    assert [str(w.message) for w in warned][:10] == printed[:10]
    assert str(warned[10].message) == "3 further doubts, which Scene.doubts tells"
    with pytest.warns(gnomon.SceneWarning):
        assert gnomon.Scene.from_dict(scene.to_dict()).doubts == scene.doubts


def test_the_plane_has_scenes_too():
    scene = gnomon.Scene(2)
    scene.add_light("tube", [[-1, 4], [1, 4]])
    scene.add_blocker("wall", [[-1, 2], [1, 2]])
    scene.add_blocker("roof", [[5, 2], [6, 3], [7, 2]])
    assert scene.dimension == 2
    assert scene.regions([[0, 1], [0, 3], [2, 0]]).region.tolist() == [[2], [0], [1]]


def test_a_dimension_or_a_unit_that_there_is_not_is_refused():
    with pytest.raises(gnomon.SceneError, match="found the number 5; expected 2 or 3"):
        gnomon.Scene(5)
    with pytest.raises(gnomon.SceneError, match="expected a unit of length among"):
        gnomon.Scene(length_unit="yd")
