"""Points get the very doubles that the program prints."""

import numpy as np
import pytest

import gnomon
from conftest import CASES, EXAMPLES, program_table

SPACE = ["figure_4_22", "cornell_box", "two_lamps", "still_life", "letter_block", "boxes", "desk"]
PLANE = ["figure_4_17", "figure_4_18_no_umbra"]


def seeded(seed: int) -> np.random.Generator:
    print("seed", seed)
    return np.random.default_rng(seed)


def points_around(scene: gnomon.Scene, generator: np.random.Generator, count: int) -> np.ndarray:
    """Points among the vertices of a scene: of its vertices themselves, and between them."""
    vertices = [v for part in scene.to_dict().values() if isinstance(part, list) for e in part for v in e.get("vertices", [])]
    corners = np.array(vertices, dtype=float)
    weights = generator.choice([0.0, 0.25, 0.5, 1.0], (count, 3))
    picked = corners[generator.integers(len(corners), size=(count, 2))]
    return picked[:, 0] + (picked[:, 1] - picked[:, 0]) * weights[:, : corners.shape[1]]


def as_csv(header: str, rows: np.ndarray) -> str:
    return header + "\n" + "".join(",".join(map(repr, row)) + "\n" for row in rows.tolist())


def column(table: list[dict[str, str]], name: str, lights: int) -> np.ndarray:
    return np.array([float(row[name]) for row in table]).reshape(-1, lights)


def assert_bounds_agree(printed: np.ndarray, exact: np.ndarray, values: np.ndarray) -> None:
    """Printed bounds also hold for the shortest decimals of values, so they are a little larger."""
    finite = np.isfinite(exact)
    assert np.array_equal(np.isfinite(printed), finite)
    assert np.all(printed[finite] >= exact[finite])
    assert np.all(printed[finite] <= exact[finite] * (1 + 1e-15) + np.spacing(values[finite]))


@pytest.mark.parametrize("name", SPACE)
def test_irradiance_is_that_of_the_program_to_the_last_bit(name):
    file = EXAMPLES / f"{name}.scene.json"
    scene = gnomon.Scene.read(file)
    generator = seeded(11)
    points = points_around(scene, generator, CASES)
    normals = generator.choice([-1.0, 0.0, 0.5, 1.0], (CASES, 3))
    normals[~normals.any(axis=1)] = [0, 0, 1]
    found = scene.irradiance(points, normals)
    table = program_table("irradiance", str(file), "--at", "-", text=as_csv("x,y,z,nx,ny,nz", np.hstack([points, normals])))
    assert [row["light"] for row in table[: len(found.lights)]] == list(found.lights)
    assert np.array_equal(column(table, "irradiance", len(found.lights)), found.irradiance)
    assert_bounds_agree(column(table, "error_bound", len(found.lights)), found.error_bound, found.irradiance)
    assert np.count_nonzero(found.irradiance) > 0


@pytest.mark.parametrize("name", SPACE)
@pytest.mark.parametrize("facing", [False, True])
def test_regions_are_those_of_the_program_to_the_last_bit(name, facing):
    file = EXAMPLES / f"{name}.scene.json"
    scene = gnomon.Scene.read(file)
    points = points_around(scene, seeded(12), CASES)
    normals = np.tile([0.0, 0.0, 1.0], (CASES, 1)) if facing else None
    found = scene.regions(points, normals)
    header, rows = ("x,y,z,nx,ny,nz", np.hstack([points, normals])) if facing else ("x,y,z", points)
    table = program_table("regions", str(file), "--at", "-", text=as_csv(header, rows))
    lights = len(found.lights)
    names = np.array([gnomon.Region(code).name.lower() for code in found.region.ravel()])
    assert [row["region"] for row in table] == names.tolist()
    assert np.array_equal(column(table, "visible_fraction", lights), found.visible_fraction)
    assert_bounds_agree(column(table, "error_bound", lights), found.error_bound, found.visible_fraction)
    if facing:
        assert np.array_equal(column(table, "before_receiver", lights), found.before_receiver)
    else:
        assert found.before_receiver is None


@pytest.mark.parametrize("name", PLANE)
def test_regions_of_the_plane_are_those_of_the_program(name):
    file = EXAMPLES / f"{name}.scene.json"
    scene = gnomon.Scene.read(file)
    points = points_around(scene, seeded(13), CASES)
    found = scene.regions(points)
    table = program_table("regions", str(file), "--at", "-", text=as_csv("x,y", points))
    names = [gnomon.Region(code).name.lower() for code in found.region.ravel()]
    assert [row["region"] for row in table] == names
    assert np.array_equal(column(table, "visible_fraction", len(found.lights)), found.visible_fraction)


def test_totals_are_those_of_the_program_and_sums_within_their_bounds():
    file = EXAMPLES / "two_lamps.scene.json"
    scene = gnomon.Scene.read(file)
    points = points_around(scene, seeded(14), 100)
    normals = np.tile([0.0, 0.0, 1.0], (100, 1))
    found = scene.irradiance(points, normals)
    values, bounds = found.total()
    assert values.shape == (100,)
    text = as_csv("x,y,z,nx,ny,nz", np.hstack([points, normals]))
    table = program_table("irradiance", str(file), "--at", "-", "--sum", text=text)
    assert np.array_equal(column(table, "irradiance", 1)[:, 0], values)
    assert np.all(bounds >= found.error_bound.sum(axis=1) * (1 - 1e-15))


def test_one_light_alone_has_the_column_it_has_among_all():
    scene = gnomon.Scene.read(EXAMPLES / "two_lamps.scene.json")
    points, normals = [[0.5, 0.25, 0]], [[0, 0, 1]]
    both = scene.irradiance(points, normals)
    for k, light in enumerate(both.lights):
        alone = scene.irradiance(points, normals, light=light)
        assert alone.lights == (light,)
        assert alone.irradiance[0, 0] == both.irradiance[0, k]
    with pytest.raises(gnomon.ArgumentError, match="light: the scene has no light 'sun'; it has"):
        scene.irradiance(points, normals, light="sun")


def test_irradiance_in_the_plane_is_refused_as_the_program_refuses_it():
    scene = gnomon.Scene.read(EXAMPLES / "figure_4_17.scene.json")
    with pytest.raises(gnomon.UnsupportedError, match="irradiance in scenes of dimension 2 is not available"):
        scene.irradiance([[0, 0, 0]], [[0, 0, 1]])
    with pytest.raises(gnomon.ArgumentError, match="normals: found some, expected None in a scene of dimension 2"):
        scene.regions([[0, 0]], [[0, 1]])


def test_irradiance_is_per_square_metre_whatever_the_unit():
    def bulb(unit: str, scale: float) -> float:
        scene = gnomon.Scene(length_unit=unit)
        scene.add_light("bulb", position=[0, 0, 2 * scale], intensity=100)
        return float(scene.irradiance([[0, 0, 0]], [[0, 0, 1]]).irradiance[0, 0])

    assert bulb("m", 1) == 25
    assert bulb("mm", 1000) == pytest.approx(25, rel=1e-15)


def test_a_point_on_a_tube_gets_infinite_irradiance_with_an_infinite_bound():
    scene = gnomon.Scene()
    scene.add_light("tube", [[0, 0, 2], [0, 0, 4]])
    found = scene.irradiance([[0, 0, 2]], [[0, 0, 1]])
    assert np.isinf(found.irradiance[0, 0]) and np.isinf(found.error_bound[0, 0])
