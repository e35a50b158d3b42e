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


def main(plugin, scene):
    simple.LoadPlugin(plugin, remote=False, ns=globals())
    reader = opened(scene)
    found = set(names(reader.GetClientSideObject().GetOutputDataObject(0)))
    expected = {"scene/lights/lamp", "scene/blockers/board", "scene/receivers/floor", "volumes/lamp/board/occlusion",
                "volumes/lamp/board/umbra", "volumes/lamp/board/penumbra", "solids/lamp/board/umbra",
                "solids/lamp/board/penumbra", "extremal_planes/lamp/board"}
    if found != expected:
        sys.exit(f"blocks: found {sorted(found)}, expected {sorted(expected)}")
    simple.Show(reader)
    simple.Render()
    print("opened by the plugin:", len(found), "blocks")


main(*sys.argv[1:])
