"""Results become data sets of VTK, of which the numbers are theirs."""

import gc
import sys

import numpy as np
import pytest

import gnomon
from conftest import EXAMPLES

pytest.importorskip("vtkmodules")
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader  # noqa: E402


def array(data, name):
    return vtk_to_numpy(data.GetPointData().GetArray(name))


def test_points_have_the_columns_of_the_tables(lamp_and_table):
    points, normals = np.random.default_rng(1).uniform(-3, 3, (20, 3)), np.tile([0, 0, 1.0], (20, 1))
    regions, irradiance = lamp_and_table.regions(points), lamp_and_table.irradiance(points, normals)
    data = regions.to_vtk()
    assert np.array_equal(vtk_to_numpy(data.GetPoints().GetData()), points)
    assert np.array_equal(array(data, "region"), regions.region[:, 0])
    assert np.array_equal(array(data, "visible_fraction"), regions.visible_fraction[:, 0])
    assert np.array_equal(array(irradiance.to_vtk(), "irradiance"), irradiance.irradiance[:, 0])
    lamp_and_table.add_light("bulb", position=[0, 0, 9])
    both = lamp_and_table.irradiance(points, normals).to_vtk()
    names = {both.GetPointData().GetArrayName(k) for k in range(both.GetPointData().GetNumberOfArrays())}
    assert names == {"irradiance_lamp", "irradiance_bulb", "error_bound_lamp", "error_bound_bulb"}
    assert both.GetNumberOfVerts() == 20
    radiance = lamp_and_table.radiance(points, normals, [9, 9, 9])
    assert np.array_equal(array(radiance.to_vtk(), "radiance_bulb"), radiance.radiance[:, 1])


def test_doubles_are_shared_with_the_result(lamp_and_table):
    points = np.zeros((3, 3))
    data = lamp_and_table.regions(points).to_vtk()
    assert np.shares_memory(vtk_to_numpy(data.GetPoints().GetData()), points)


def test_data_sets_outlive_what_they_are_made_of():
    data = gnomon.Scene.read(EXAMPLES / "figure_4_22.scene.json").receivers()[0].to_vtk()
    wanted = gnomon.Scene.read(EXAMPLES / "figure_4_22.scene.json").receivers()[0].triangles()
    for _ in range(10):
        gc.collect()
        filling = [np.full(1000, 7.5) for _ in range(1000)]
    assert len(filling) == 1000
    assert np.array_equal(vtk_to_numpy(data.GetPoints().GetData()), wanted[0])
    assert np.array_equal(vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3), wanted[1])
    assert np.array_equal(vtk_to_numpy(data.GetCellData().GetArray("face")), wanted[2])
    assert data.GetCell(0).GetNumberOfPoints() == 3


def test_surfaces_have_triangles_with_their_faces():
    scene = gnomon.Scene.read(EXAMPLES / "figure_4_22.scene.json")
    (floor,) = scene.receivers()
    umbra = scene.pair("lamp", "board").volume("umbra")
    (mesh,) = scene.illuminate(relative=0.2)
    (curved,) = scene.illuminate(relative=0.2, order=2)
    plane = gnomon.Scene.read(EXAMPLES / "figure_4_17.scene.json").partition()
    for result, count in ((floor, len(floor.triangles()[1])), (umbra, len(umbra.triangles)), (mesh, len(mesh.faces())),
                          (curved, len(curved.faces())), (plane, len(plane.triangles()[1]))):
        data = result.to_vtk()
        assert data.GetNumberOfCells() == count
        scalars = vtk_to_numpy(data.GetCellData().GetScalars())
        assert scalars.shape == (count,)
    assert np.array_equal(vtk_to_numpy(umbra.to_vtk().GetPolys().GetConnectivityArray()).reshape(-1, 3), umbra.triangles)
    assert {curved.to_vtk().GetCellType(0)} == {22}


def test_files_are_written_whole_or_not_at_all(tmp_path, lamp_and_table):
    result = lamp_and_table.regions(np.eye(3))
    gnomon.write_vtk(result, tmp_path / "points.vtp")
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(tmp_path / "points.vtp"))
    reader.Update()
    assert np.array_equal(array(reader.GetOutput(), "region"), result.region[:, 0])
    assert [file.name for file in tmp_path.iterdir()] == ["points.vtp"]
    with pytest.raises(ValueError, match="expected a name that ends in .vtp"):
        gnomon.write_vtk(result, tmp_path / "points.txt")
    with pytest.raises(OSError):
        gnomon.write_vtk(result, tmp_path / "nowhere" / "points.vtp")


def test_without_vtk_a_sentence_says_where_it_is(lamp_and_table, monkeypatch):
    for name in [name for name in sys.modules if name.startswith("vtkmodules")]:
        monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(gnomon.UnsupportedError, match="python3-vtk9"):
        lamp_and_table.regions(np.eye(3)).to_vtk()
