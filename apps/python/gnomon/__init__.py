"""Exact shadow geometry: umbra, penumbra and light, decided exactly, with numpy arrays in and out.

    import gnomon
    scene = gnomon.Scene()
    scene.add_light("lamp", [[-1, -1, 4], [-1, 1, 4], [1, 1, 4], [1, -1, 4]], radiance=100)
    scene.add_blocker("table", [[-1, -1, 2], [1, -1, 2], [1, 1, 2], [-1, 1, 2]])
    scene.irradiance([[0, 0, 0], [3, 0, 0]], [[0, 0, 1], [0, 0, 1]]).irradiance
"""

from gnomon._gnomon import (
    DividedReceiver,
    IlluminatedReceiver,
    Irradiance,
    Pair,
    Partition,
    Radiance,
    Regions,
    Scene,
    ViewFactors,
    Volume,
    __version__,
)
from gnomon.errors import ArgumentError, Error, SceneError, SceneWarning, UnsupportedError
from gnomon.proof import theorems
from gnomon.regions import Region
from gnomon.results import Arc, Element, Event, Plane
from gnomon.vtk_data import to_vtk, write_vtk

__all__ = [
    "Arc",
    "ArgumentError",
    "DividedReceiver",
    "Element",
    "Error",
    "Event",
    "IlluminatedReceiver",
    "Irradiance",
    "Pair",
    "Partition",
    "Plane",
    "Radiance",
    "Region",
    "Regions",
    "Scene",
    "SceneError",
    "SceneWarning",
    "UnsupportedError",
    "ViewFactors",
    "Volume",
    "__version__",
    "theorems",
    "to_vtk",
    "write_vtk",
]
