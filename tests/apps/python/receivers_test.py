"""Divided receivers are those of the program; their areas are exact."""

import json
import warnings
from fractions import Fraction

import numpy as np
import pytest

import gnomon
from conftest import EXAMPLES, run_program


def facets_of(document: dict) -> list[tuple[str, str, dict]]:
    """Light, side and mesh of every flat piece of every receiver."""
    pieces = []
    for receiver in document["receivers"]:
        for mesh in receiver.get("meshes", [receiver.get("mesh")]):
            pieces.append((receiver["light"], receiver["name"], mesh))
    return pieces


@pytest.mark.parametrize("name", ["figure_4_22", "figure_4_23", "cornell_box", "two_lamps", "boxes", "four_umbrae"])
def test_meshes_are_those_of_the_program(name):
    file = EXAMPLES / f"{name}.scene.json"
    document = json.loads(run_program("receivers", str(file), "--mesh", "faces,edges,polygons", "--json", "-", "--quiet"))
    found = gnomon.Scene.read(file).receivers()
    pieces = facets_of(document)
    assert [(one.light, one.side) for one in found] == [(light, side) for light, side, _ in pieces]
    for one, (_, _, mesh) in zip(found, pieces):
        assert one.vertices().tolist() == mesh["vertices"]
        assert one.edges().tolist() == [edge["vertices"] for edge in mesh["edges"]]
        arcs = [(e, tuple(edge["arc"]["control_point"]), edge["arc"]["weight"])
                for e, edge in enumerate(mesh["edges"]) if "arc" in edge]
        assert list(one.arcs()) == arcs
        beyond = [[-1 if f is None else f for f in (edge["left"], edge["right"])] for edge in mesh["edges"]]
        assert one.edge_faces().tolist() == beyond
        assert [list(names) for names in one.edge_events()] == [edge["events"] for edge in mesh["edges"]]
        assert [[cycle.tolist() for cycle in face] for face in one.faces()] == [f["cycles"] for f in mesh["faces"]]
        regions = [gnomon.Region(code).name.lower() for code in one.face_regions()]
        assert regions == [f["region"] for f in mesh["faces"]]
        polygons = [{"region": r.name.lower(), "cycles": [c.tolist() for c in cycles]} for r, cycles in one.polygons()]
        assert polygons == [{"region": p["region"], "cycles": p["cycles"]} for p in mesh["polygons"]]
        for event, told in zip(one.events(), mesh["events"], strict=True):
            elements = told.get("edges") or [told["vertex"], told["edge"]]
            assert event.kind == told["kind"]
            assert [{"of": e.of, "index": e.number} for e in event.elements] == elements
            assert event.order == told.get("order") and event.extremal == told.get("extremal", "none")


def test_areas_are_fractions_that_add_up_exactly():
    (floor,) = gnomon.Scene.read(EXAMPLES / "figure_4_22.scene.json").receivers()
    exact = floor.exact_areas()
    assert exact[gnomon.Region.UMBRA] == Fraction(49, 8)
    assert exact[gnomon.Region.PENUMBRA] == Fraction(2625, 128)
    assert sum(exact.values()) == floor.exact_area() == 80
    assert floor.areas() == {region: float(area) for region, area in exact.items()}
    assert floor.area() == 80
    assert repr(floor) == "<gnomon.DividedReceiver 'floor' under 'lamp': 24 faces>"


def test_areas_with_arcs_are_no_fractions():
    (floor,) = gnomon.Scene.read(EXAMPLES / "four_umbrae.scene.json").receivers()
    assert len(floor.arcs()) > 0
    assert floor.exact_areas()[gnomon.Region.UMBRA] is None
    assert floor.areas()[gnomon.Region.UMBRA] == pytest.approx(3.106195091019361, abs=1e-12)


def test_triangles_cover_their_faces():
    (floor,) = gnomon.Scene.read(EXAMPLES / "figure_4_22.scene.json").receivers()
    points, triangles, faces = floor.triangles()
    assert np.array_equal(points[: len(floor.vertices())], floor.vertices())
    sides = points[triangles]
    doubled = np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0])[:, 2]
    assert np.all(doubled > 0)
    umbra = floor.face_regions()[faces] == gnomon.Region.UMBRA
    assert doubled[umbra].sum() / 2 == pytest.approx(49 / 8, rel=1e-14)


def test_visible_fractions_stand_at_vertices_where_they_are_asked_for():
    scene = gnomon.Scene.read(EXAMPLES / "figure_4_22.scene.json")
    assert scene.receivers()[0].visible_fractions() is None
    (floor,) = scene.receivers(fractions=True)
    fractions = floor.visible_fractions()
    seen = scene.regions(floor.vertices(), np.tile([0, 0, 1], (len(fractions), 1)))
    assert np.all(np.abs(seen.visible_fraction[:, 0] - fractions) <= 1e-12)


def test_one_receiver_under_one_light_is_chosen_by_name():
    scene = gnomon.Scene.read(EXAMPLES / "two_lamps.scene.json")
    light, receiver = scene.light_names[0], scene.receiver_names[0]
    chosen = scene.receivers(receiver, light=light, threads=1)
    assert {(one.light, one.side) for one in chosen} == {(light, receiver)}
    with pytest.raises(gnomon.ArgumentError, match="receiver: the scene has no receiver 'roof'; it has '"):
        scene.receivers("roof")
    with pytest.raises(gnomon.ArgumentError, match="light: the scene has no light 'sun'; it has '"):
        scene.receivers(light="sun")


def test_what_is_not_supported_is_refused_or_left_out_with_the_sentence_of_the_program():
    with pytest.raises(gnomon.UnsupportedError, match="need a scene of dimension 3"):
        gnomon.Scene.read(EXAMPLES / "figure_4_17.scene.json").receivers()
    scene = gnomon.Scene()
    scene.add_light("bent", [[0, 0, 4], [0, 1, 4], [1, 1, 4 + 1e-12], [1, 0, 4]])
    scene.add_receiver("floor", [[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0]])
    with pytest.raises(gnomon.UnsupportedError, match="light 'bent'"):
        scene.receivers()
    scene.add_light("bulb", position=[0, 0, 3])
    with pytest.warns(gnomon.SceneWarning, match="light 'bent'"):
        assert [one.light for one in scene.receivers()] == ["bulb"]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(gnomon.SceneWarning):
            scene.receivers()
