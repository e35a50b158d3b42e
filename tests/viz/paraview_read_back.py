"""Reads a written result with ParaView: pvbatch paraview_read_back.py FOLDER

Compares names, arrays and counts of all blocks with manifest.json, then lets view.py make a picture.
"""

import json
import os
import runpy
import sys
import tempfile

from paraview import servermanager, simple
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkMultiBlockDataSet
from vtkmodules.vtkIOImage import vtkPNGReader

failures = []


def expect_equal(found, expected, what):
    if found != expected:
        failures.append(f"{what}: found {found!r}, expected {expected!r}")


def multiblock_leaves(tree, path=()):
    for i in range(tree.GetNumberOfBlocks()):
        block = tree.GetBlock(i)
        here = path + (tree.GetMetaData(i).Get(vtkCompositeDataSet.NAME()),)
        if isinstance(block, vtkMultiBlockDataSet):
            yield from multiblock_leaves(block, here)
        else:
            yield "/".join(here), block


def leaves(data):
    if isinstance(data, vtkMultiBlockDataSet):
        return list(multiblock_leaves(data))
    return [(data.GetMetaData(i).Get(vtkCompositeDataSet.NAME()), data.GetPartition(i, 0))
            for i in range(data.GetNumberOfPartitionedDataSets())]


def array_names(attributes):
    return [attributes.GetAbstractArray(i).GetName() for i in range(attributes.GetNumberOfArrays())]


def check_block(name, data, listed):
    expect_equal(data.GetNumberOfPoints(), listed["points"], f"points of {name}")
    expect_equal(data.GetNumberOfCells(), listed["cells"], f"cells of {name}")
    expect_equal(array_names(data.GetCellData()), listed["cell_arrays"], f"cell arrays of {name}")
    expected_names = sorted([*listed["field_data"], "generation"])
    expect_equal(sorted(array_names(data.GetFieldData())), expected_names, f"field data of {name}")
    found = data.GetFieldData().GetAbstractArray("generation")
    expect_equal(found and found.GetValue(0), listed["generation"], f"generation of {name}")


def check_blocks(folder, manifest):
    reader = simple.OpenDataFile(os.path.join(folder, manifest["roots"][0]))
    reader.UpdatePipeline()
    data = reader.GetClientSideObject().GetOutputDataObject(0)
    listed = {block["name"]: block for block in manifest["blocks"] if not block["empty"]}
    found = leaves(data)
    expect_equal(sorted(name for name, _ in found), sorted(listed), "block names")
    for name, block in found:
        if name in listed:
            check_block(name, block, listed[name])
    # The reader may add arrays of its own.
    missing = set(manifest["field_data"]) - set(array_names(data.GetFieldData()))
    expect_equal(missing, set(), "field data that the root has lost")
    simple.Delete(reader)


def check_volumes(folder, manifest):
    """ParaView measures the solids as the manifest does."""
    for block in manifest["blocks"]:
        if block["kind"] != "solid" or block["empty"]:
            continue
        reader = simple.OpenDataFile(os.path.join(folder, block["file"]))
        sizes = servermanager.Fetch(simple.CellSize(Input=reader)).GetCellData().GetArray("Volume")
        volume = sum(sizes.GetValue(i) for i in range(sizes.GetNumberOfTuples()))
        expected = block["field_data"]["volume_total"][0]
        if not abs(volume - expected) <= 1e-9 * expected:
            failures.append(f"volume of {block['name']}: found {volume!r}, expected {expected!r}")


def colors(picture):
    reader = vtkPNGReader()
    reader.SetFileName(picture)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return {tuple(int(image.GetScalarComponentAsDouble(x, y, 0, k)) for k in range(3))
            for x in range(0, width, 4) for y in range(0, height, 4)}


def expect_colors(seen, kinds, palette):
    """Lines have the very colours of view.py, whatever the light in the picture."""
    orders = {(217, 20, 89): "D1", (122, 235, 122): "D2"}
    for color, name in orders.items():
        if "receiver_edges" in kinds and color not in seen:
            failures.append(f"the picture of view.py shows no {name} line on receivers")
    if "receiver_faces" in kinds:
        for region in ("lit", "penumbra", "umbra"):
            if tuple(round(255 * value) for value in palette[region]) not in seen:
                failures.append(f"the picture of view.py shows no {region} on receivers in the colour of the palette")


def expect_backs_apart():
    """What a receiver receives is shown on its front only, and there is something else behind."""
    culled = {"receiver faces of ": "Cull Backface", "backs of receivers of ": "Cull Frontface"}
    for start, expected in culled.items():
        shown = [source for (name, _), source in simple.GetSources().items() if name.startswith(start)]
        if not shown or any(simple.GetDisplayProperties(s).BackfaceRepresentation != expected for s in shown):
            failures.append(f"view.py does not keep fronts and backs of receivers apart: {start}")


def check_view(folder, kinds, palette):
    with tempfile.TemporaryDirectory() as place:
        picture = os.path.join(place, "folder that is not there", "picture.png")
        script = os.path.join(folder, "view.py")
        sys.argv = [script, "--screenshot", picture]
        runpy.run_path(script, run_name="__main__")
        if not os.path.exists(picture):
            failures.append("view.py has made no picture")
            return
        seen = colors(picture)
        if len(seen) < 20:
            failures.append(f"the picture of view.py is blank or nearly so: {len(seen)} colours")
        expect_colors(seen, kinds, palette)
    if "receiver_faces" in kinds:
        expect_backs_apart()


folder = sys.argv[1]
with open(os.path.join(folder, "manifest.json"), encoding="utf-8") as file:
    manifest = json.load(file)
check_blocks(folder, manifest)
check_volumes(folder, manifest)
check_view(folder, {block["kind"] for block in manifest["blocks"]}, manifest["palette"])
if not manifest["blocks"]:
    failures.append("the manifest lists no blocks")
for failure in failures:
    print(failure, file=sys.stderr)
print(f"{len(manifest['blocks'])} blocks compared, {len(failures)} failures")
sys.stdout.flush()
# Leaving through exit codes is all that pvbatch hands on.
os._exit(1 if failures else 0)
