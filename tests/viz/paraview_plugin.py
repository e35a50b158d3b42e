"""Opens a scene with the plugin: pvbatch paraview_plugin.py PLUGIN SCENE; GNOMON names the program."""

import sys

from paraview import simple
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkMultiBlockDataSet


def names(tree, path=()):
    for i in range(tree.GetNumberOfBlocks()):
        here = path + (tree.GetMetaData(i).Get(vtkCompositeDataSet.NAME()),)
        block = tree.GetBlock(i)
        if isinstance(block, vtkMultiBlockDataSet):
            yield from names(block, here)
        else:
            yield "/".join(here)


def opened(scene):
    reader = simple.OpenDataFile(scene)
    if reader is None or reader.SMProxy.GetXMLName() != "GnomonScene":
        sys.exit(f"{scene} is not opened by the plugin")
    reader.UpdatePipeline()
    return reader


def expect(reader, expected):
    reader.UpdatePipeline()
    found = set(names(reader.GetClientSideObject().GetOutputDataObject(0)))
    if found != expected:
        sys.exit(f"blocks: found {sorted(found)}, expected {sorted(expected)}")


def main(plugin, scene):
    simple.LoadPlugin(plugin, remote=False, ns=globals())
    reader = opened(scene)
    useful = {"scene/lights/lamp", "scene/blockers/board", "volumes/lamp/board/umbra", "volumes/lamp/board/penumbra",
              "receivers/lamp/floor/faces"}
    expect(reader, useful)
    simple.Show(reader)
    simple.Render()
    reader.Occlusion = 1
    expect(reader, useful | {"volumes/lamp/board/occlusion"})
    reader.Occlusion = 0
    reader.ExtremalPlanes = 1
    reader.Solids = 1
    expect(reader, useful | {"extremal_planes/lamp/board", "solids/lamp/board/umbra", "solids/lamp/board/penumbra"})
    print("opened by the plugin:", len(useful), "blocks at first sight")


main(*sys.argv[1:])
