"""A ParaView plugin that opens gnomon's scene files (*.scene.json): it runs gnomon and shows the blocks.

In ParaView: Tools > Manage Plugins > Load New, and this file. In a script: LoadPlugin(FILE, ns=globals()).

The program is the one that the environment's GNOMON names, or the one installed with this file, or the one on the path.
"""

import os
import shutil
import subprocess
import tempfile

from paraview.util.vtkAlgorithm import VTKPythonAlgorithmBase, smdomain, smhint, smproperty, smproxy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkIOXML import vtkXMLMultiBlockDataReader


def gnomon_program():
    """Where gnomon is. Raises RuntimeError where it is not."""
    beside = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "..", "bin", "gnomon")
    for name in (os.environ.get("GNOMON"), beside, shutil.which("gnomon")):
        if name and os.access(name, os.X_OK):
            return name
    raise RuntimeError("the program gnomon is not found: put it on the path, or name it in the environment's GNOMON")


@smproxy.reader(name="GnomonScene", label="gnomon scene", extensions="json", file_description="gnomon scenes",
                filename_patterns="*.scene.json")
class GnomonScene(VTKPythonAlgorithmBase):
    """Lights, blockers, receivers and shadow volumes of a scene."""

    def __init__(self):
        VTKPythonAlgorithmBase.__init__(self, nInputPorts=0, nOutputPorts=1, outputType="vtkMultiBlockDataSet")
        self._file = None
        self._light = ""
        self._blocker = ""

    @smproperty.stringvector(name="FileName", panel_visibility="never")
    @smdomain.filelist()
    @smhint.filechooser(extensions="json", file_description="gnomon scenes")
    def SetFileName(self, name):
        if self._file != name:
            self._file = name
            self.Modified()

    @smproperty.stringvector(name="Light", default_values="")
    def SetLight(self, name):
        """Only the pairs of this light; empty for all."""
        if self._light != (name or ""):
            self._light = name or ""
            self.Modified()

    @smproperty.stringvector(name="Blocker", default_values="")
    def SetBlocker(self, name):
        """Only the pairs of this blocker; empty for all."""
        if self._blocker != (name or ""):
            self._blocker = name or ""
            self.Modified()

    def command(self, folder):
        words = [gnomon_program(), "shadow", self._file, "--out", folder, "--quiet"]
        for option, name in (("--light", self._light), ("--blocker", self._blocker)):
            if name:
                words += [option, name]
        return words

    def RequestData(self, request, inputs, outputs):
        with tempfile.TemporaryDirectory(prefix="gnomon-") as folder:
            run = subprocess.run(self.command(folder), capture_output=True, text=True)
            if run.stderr:
                print(run.stderr, end="")
            if run.returncode != 0:
                raise RuntimeError(run.stderr.strip() or f"gnomon ended with code {run.returncode}")
            reader = vtkXMLMultiBlockDataReader()
            reader.SetFileName(os.path.join(folder, "shadow.vtm"))
            reader.Update()
            vtkMultiBlockDataSet.GetData(outputs, 0).ShallowCopy(reader.GetOutput())
        return 1
