"""A ParaView plugin that opens gnomon's scene files (*.scene.json): it runs gnomon and shows the blocks.

In ParaView: Tools > Manage Plugins > Load New, and this file. In a script: LoadPlugin(FILE, ns=globals()).

The program is the one that the environment's GNOMON names, or the one installed with this file, or the one on the path.
"""

import json
import os
import shutil
import subprocess
import tempfile

from paraview.util.vtkAlgorithm import VTKPythonAlgorithmBase, smdomain, smhint, smproperty, smproxy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkMultiBlockDataSet
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataReader


def gnomon_program():
    """Where gnomon is. Raises RuntimeError where it is not."""
    beside = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "bin", "gnomon")
    for name in (os.environ.get("GNOMON"), beside, shutil.which("gnomon")):
        if name and os.access(name, os.X_OK):
            return name
    raise RuntimeError("the program gnomon is not found: put it on the path, or name it in the environment's GNOMON")


def pruned(tree, is_wanted, path=()):
    """The blocks of a tree whose path is wanted, under the names that they had."""
    result = vtkMultiBlockDataSet()
    for i in range(tree.GetNumberOfBlocks()):
        name = tree.GetMetaData(i).Get(vtkCompositeDataSet.NAME())
        block, here = tree.GetBlock(i), path + (name,)
        if isinstance(block, vtkMultiBlockDataSet):
            block = pruned(block, is_wanted, here)
            if block.GetNumberOfBlocks() == 0:
                continue
        elif not is_wanted(here):
            continue
        at = result.GetNumberOfBlocks()
        result.SetBlock(at, block)
        result.GetMetaData(at).Set(vtkCompositeDataSet.NAME(), name)
    result.GetFieldData().ShallowCopy(tree.GetFieldData())
    return result


@smproxy.reader(name="GnomonScene", label="gnomon scene", extensions="json", file_description="gnomon scenes",
                filename_patterns="*.scene.json")
class GnomonScene(VTKPythonAlgorithmBase):
    """A light, blockers, receivers in their regions and shadow volumes of a scene."""

    def __init__(self):
        VTKPythonAlgorithmBase.__init__(self, nInputPorts=0, nOutputPorts=1, outputType="vtkMultiBlockDataSet")
        self._file = None
        self._light = ""
        self._blocker = ""
        self._shown = set()

    def _set(self, name, value):
        if getattr(self, name) != value:
            setattr(self, name, value)
            self.Modified()

    def _show(self, what, value):
        self._set("_shown", self._shown | {what} if value else self._shown - {what})

    @smproperty.stringvector(name="FileName", panel_visibility="never")
    @smdomain.filelist()
    @smhint.filechooser(extensions="json", file_description="gnomon scenes")
    def SetFileName(self, name):
        self._set("_file", name)

    @smproperty.stringvector(name="Light", default_values="")
    def SetLight(self, name):
        """One light: what several make of one receiver lies in one place. Empty for the first."""
        self._set("_light", name or "")

    @smproperty.stringvector(name="Blocker", default_values="")
    def SetBlocker(self, name):
        """Only the volumes of this blocker; empty for all."""
        self._set("_blocker", name or "")

    @smproperty.intvector(name="Occlusion", default_values=0)
    @smdomain.xml('<BooleanDomain name="bool"/>')
    def SetOcclusion(self, value):
        """Occlusion volumes too, which are umbra and penumbra together."""
        self._show("occlusion", value)

    @smproperty.intvector(name="ExtremalPlanes", default_values=0)
    @smdomain.xml('<BooleanDomain name="bool"/>')
    def SetExtremalPlanes(self, value):
        self._show("extremal_planes", value)

    @smproperty.intvector(name="Solids", default_values=0)
    @smdomain.xml('<BooleanDomain name="bool"/>')
    def SetSolids(self, value):
        """Umbra and penumbra in convex cells, to be sliced and measured."""
        self._show("solids", value)

    @smproperty.intvector(name="VolumesOfParts", default_values=0)
    @smdomain.xml('<BooleanDomain name="bool"/>')
    def SetVolumesOfParts(self, value):
        """The volumes of blockers that are several convex parts, part by part."""
        self._show("parts", value)

    def command(self, folder):
        words = [gnomon_program(), "shadow", self._file, "--out", folder, "--quiet"]
        for option, name in (("--light", self._light), ("--blocker", self._blocker)):
            if name:
                words += [option, name]
        return words

    def _is_wanted(self, manifest):
        """Which blocks are useful at first sight, and those that are asked for."""
        blocks = [block["path"] for block in manifest["blocks"] if block["file"]]
        with_results = {path[1] for path in blocks if path[0] != "scene"}
        lights = [path[2] for path in blocks if path[:2] == ["scene", "lights"]]
        light = next((name for name in lights if name in with_results), lights[0] if lights else "")
        whole = {path[2] for path in blocks if path[:2] == ["scene", "blockers"]}
        divided = {path[2] for path in blocks if path[0] == "receivers" and path[1] == light}

        def is_wanted(path):
            if path[0] == "scene":
                return path[2] == light if path[1] == "lights" else path[1] != "receivers" or path[2] not in divided
            if path[1] != light:
                return False
            if path[0] == "volumes" and path[3] not in ("umbra", "penumbra", "umbra_pockets") and \
                    "occlusion" not in self._shown:
                return False
            if path[0] in ("volumes", "solids", "extremal_planes") and manifest["dimension"] == 3:
                if path[2] not in whole and "parts" not in self._shown:
                    return False
            return path[0] not in ("solids", "extremal_planes") or path[0] in self._shown

        return is_wanted

    def RequestData(self, request, inputs, outputs):
        with tempfile.TemporaryDirectory(prefix="gnomon-") as folder:
            run = subprocess.run(self.command(folder), capture_output=True, text=True)
            if run.stderr:
                print(run.stderr, end="")
            if run.returncode != 0:
                raise RuntimeError(run.stderr.strip() or f"gnomon ended with code {run.returncode}")
            with open(os.path.join(folder, "manifest.json"), encoding="utf-8") as file:
                is_wanted = self._is_wanted(json.load(file))
            reader = vtkXMLMultiBlockDataReader()
            reader.SetFileName(os.path.join(folder, "shadow.vtm"))
            reader.Update()
            vtkMultiBlockDataSet.GetData(outputs, 0).ShallowCopy(pruned(reader.GetOutput(), is_wanted))
        return 1
