"""Radiance is what the program prints, to the last bit."""

import numpy as np
import pytest

import gnomon
from conftest import EXAMPLES, program_table


def views(seed: int, count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    print("seed", seed)
    generator = np.random.default_rng(seed)
    points = generator.integers(-4, 5, (count, 3)) / 2
    normals = generator.choice([-1.0, 0.0, 0.5, 1.0], (count, 3))
    normals[~normals.any(axis=1)] = [0, 0, 1]
    return points, normals, points + generator.integers(1, 5, (count, 3))


@pytest.mark.parametrize(("name", "material"), [("two_lamps", ""), ("still_life", "clay"), ("cornell_box", "")])
def test_radiance_is_that_of_the_program_to_the_last_bit(name, material):
    file = EXAMPLES / f"{name}.scene.json"
    scene = gnomon.Scene.read(file)
    if material:
        material = scene.to_dict()["materials"][0]["name"]
    points, normals, eyes = views(21, 60)
    found = scene.radiance(points, normals, eyes, material=material)
    lines = "".join(",".join(map(repr, row)) + "\n" for row in np.hstack([points, normals, eyes]).tolist())
    options = ["--material", material] if material else []
    table = program_table("radiance", str(file), "--at", "-", *options, text="x,y,z,nx,ny,nz,ex,ey,ez\n" + lines)
    rows = len(found.lights) + 2
    assert [row["light"] for row in table[:rows]] == [*found.lights, "ambient", "total"]
    coloured = "radiance_r" in table[0]
    names = ["radiance_r", "radiance_g", "radiance_b"] if coloured else ["radiance"] * 3
    printed = np.array([[float(row[n]) for n in names] for row in table]).reshape(60, rows, 3)
    assert np.array_equal(printed[:, :-2], found.radiance)
    assert np.array_equal(printed[:, -2], found.ambient)
    assert np.array_equal(printed[:, -1], found.total()[0])
    assert np.count_nonzero(found.radiance) > 0
    assert np.all(found.error_bound >= 0) and np.all(found.total()[1] >= found.error_bound.max(axis=1))


def test_one_eye_may_look_at_all_points():
    scene = gnomon.Scene.read(EXAMPLES / "two_lamps.scene.json")
    points, normals, _ = views(22, 20)
    eye = [5.0, 6.0, 7.0]
    for eyes in (eye, [eye], np.array(eye), np.tile(eye, (20, 1))):
        assert np.array_equal(scene.radiance(points, normals, eyes).radiance, scene.radiance(points, normals, eye).radiance)
    with pytest.raises(gnomon.ArgumentError, match="eyes: found 2 rows, expected 20, as many as points"):
        scene.radiance(points, normals, [eye, eye])
    with pytest.raises(gnomon.ArgumentError, match="eyes: found"):
        scene.radiance(points, normals, 5)


def test_an_eye_in_the_point_itself_sees_nothing():
    scene = gnomon.Scene.read(EXAMPLES / "two_lamps.scene.json")
    found = scene.radiance([[1, 0, 0]], [[0, 0, 1]], [1, 0, 0])
    assert not found.radiance.any() and not found.error_bound.any()


def test_a_material_is_named_where_there_are_several():
    scene = gnomon.Scene.read(EXAMPLES / "still_life.scene.json")
    with pytest.raises(gnomon.ArgumentError, match="material: the scene has several materials"):
        scene.radiance([[0, 0, 0]], [[0, 0, 1]], [0, 0, 1])
    with pytest.raises(gnomon.ArgumentError, match="material: the scene has no material 'gold'; it has '"):
        scene.radiance([[0, 0, 0]], [[0, 0, 1]], [0, 0, 1], material="gold")
