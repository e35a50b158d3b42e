"""Results as VTK's data sets, which ParaView reads and pyvista wraps. Needs the Python package vtk."""

import importlib
import os
import pathlib
import tempfile
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gnomon._gnomon import DividedReceiver, IlluminatedReceiver, Irradiance, Partition, Radiance, Regions, Volume
from gnomon.errors import UnsupportedError

Result = Regions | Irradiance | Radiance | DividedReceiver | IlluminatedReceiver | Volume | Partition
Arrays = dict[str, NDArray[Any]]

_QUADRATIC_TRIANGLE = 22


def _module(name: str) -> Any:
    try:
        return importlib.import_module("vtkmodules." + name)
    except ImportError as error:
        raise UnsupportedError(
            "data sets of VTK need the Python package vtk, which is not there; it is Debian's package python3-vtk9"
        ) from error


def _vtk_array(values: NDArray[Any], name: str = "") -> Any:
    """The array itself where it lies row by row, else a copy."""
    array = _module("util.numpy_support").numpy_to_vtk(np.ascontiguousarray(values))
    if name:
        array.SetName(name)
    return array


def _points(coordinates: NDArray[np.float64]) -> Any:
    if coordinates.shape[1] == 2:
        coordinates = np.column_stack([coordinates, np.zeros(len(coordinates))])
    points = _module("vtkCommonCore").vtkPoints()
    points.SetDataTypeToDouble()
    points.SetData(_vtk_array(coordinates))
    return points


def _cells(corners: NDArray[Any]) -> Any:
    """Indices are copied: a vtkCellArray would not keep numpy's memory alive."""
    count, size = corners.shape
    copied = _module("util.numpy_support").numpy_to_vtkIdTypeArray
    offsets = np.arange(0, count * size + 1, size, dtype=np.int64)
    cells = _module("vtkCommonDataModel").vtkCellArray()
    cells.SetData(copied(offsets, deep=1), copied(corners.astype(np.int64).ravel(), deep=1))
    return cells


def _with_arrays(data: Any, point_arrays: Arrays, cell_arrays: Arrays) -> Any:
    for name, values in point_arrays.items():
        data.GetPointData().AddArray(_vtk_array(values, name))
    for name, values in cell_arrays.items():
        data.GetCellData().AddArray(_vtk_array(values, name))
    if point_arrays:
        data.GetPointData().SetActiveScalars(next(iter(point_arrays)))
    if cell_arrays:
        data.GetCellData().SetActiveScalars(next(iter(cell_arrays)))
    return data


def _surface(points: NDArray[np.float64], triangles: NDArray[Any], point_arrays: Arrays, cell_arrays: Arrays) -> Any:
    data = _module("vtkCommonDataModel").vtkPolyData()
    data.SetPoints(_points(points))
    data.SetPolys(_cells(triangles))
    return _with_arrays(data, point_arrays, cell_arrays)


def _point_set(points: NDArray[np.float64], arrays: Arrays) -> Any:
    data = _module("vtkCommonDataModel").vtkPolyData()
    data.SetPoints(_points(points))
    data.SetVerts(_cells(np.arange(len(points)).reshape(-1, 1)))
    return _with_arrays(data, arrays, {})


def _columns(name: str, values: NDArray[Any], lights: tuple[str, ...]) -> Arrays:
    """NAME where there is one light, NAME_LIGHT of each where there are several."""
    if len(lights) == 1:
        return {name: values[:, 0]}
    return {f"{name}_{light}": values[:, k] for k, light in enumerate(lights)}


def _regions(result: Regions) -> Any:
    arrays = _columns("region", result.region, result.lights)
    arrays |= _columns("visible_fraction", result.visible_fraction, result.lights)
    arrays |= _columns("error_bound", result.error_bound, result.lights)
    return _point_set(result.points, arrays)


def _irradiance(result: Irradiance) -> Any:
    arrays = _columns("irradiance", result.irradiance, result.lights)
    arrays |= _columns("error_bound", result.error_bound, result.lights)
    return _point_set(result.points, arrays)


def _radiance(result: Radiance) -> Any:
    arrays = _columns("radiance", result.radiance, result.lights)
    arrays |= _columns("error_bound", result.error_bound, result.lights)
    return _point_set(result.points, arrays | {"ambient": result.ambient})


def _divided(result: DividedReceiver) -> Any:
    points, triangles, faces = result.triangles()
    return _surface(points, triangles, {}, {"region": result.face_regions()[faces], "face": faces})


def _partition(result: Partition) -> Any:
    points, triangles, faces = result.triangles()
    return _surface(points, triangles, {}, {"region": result.face_regions()[faces], "face": faces})


def _volume(result: Volume) -> Any:
    return _surface(result.vertices, result.triangles, {}, {"facet": result.triangle_facets})


def _illuminated(result: IlluminatedReceiver) -> Any:
    point_arrays: Arrays = {"irradiance": result.irradiance(), "error_bound": result.error_bound()}
    cell_arrays: Arrays = {"interpolation_error": result.face_error()}
    faces = result.faces()
    if faces.shape[1] == 3:
        return _surface(result.points(), faces, point_arrays, cell_arrays)
    data = _module("vtkCommonDataModel").vtkUnstructuredGrid()
    data.SetPoints(_points(result.points()))
    data.SetCells(_QUADRATIC_TRIANGLE, _cells(faces))
    return _with_arrays(data, point_arrays, cell_arrays)


_MAKERS = {
    Regions: _regions,
    Irradiance: _irradiance,
    Radiance: _radiance,
    DividedReceiver: _divided,
    IlluminatedReceiver: _illuminated,
    Volume: _volume,
    Partition: _partition,
}


def to_vtk(result: Result) -> Any:
    """The result as a vtkPolyData, of quadratic faces a vtkUnstructuredGrid.

    Points have arrays named as the columns of the program's tables: region, visible_fraction, irradiance, radiance,
    error_bound, with _LIGHT behind them where there are several lights; faces have region or interpolation_error.
    Arrays are shared with the result where they lie row by row. Raises UnsupportedError where vtk is not installed.
    """
    return _MAKERS[type(result)](result)  # type: ignore[operator]


def write_vtk(result: Result, file: str | os.PathLike[str]) -> None:
    """Writes to_vtk(result) as a file for ParaView: .vtp, of quadratic faces .vtu.

    It is written under another name first, so that there is never half a file. Raises OSError where it cannot be
    written, ValueError for another ending.
    """
    data = to_vtk(result)
    path = pathlib.Path(file)
    ending = ".vtp" if data.IsA("vtkPolyData") else ".vtu"
    if path.suffix != ending:
        raise ValueError(f"{path}: expected a name that ends in {ending}")
    name = "vtkXMLPolyDataWriter" if ending == ".vtp" else "vtkXMLUnstructuredGridWriter"
    writer = getattr(_module("vtkIOXML"), name)()
    writer.SetInputData(data)
    with tempfile.TemporaryDirectory(dir=path.absolute().parent, prefix=".gnomon-") as folder:
        written = pathlib.Path(folder) / path.name
        writer.SetFileName(str(written))
        if writer.Write() != 1:
            raise OSError(f"{path}: cannot be written")
        written.replace(path)
