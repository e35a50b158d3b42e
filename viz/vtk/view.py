"""Shows the result that lies beside this file in ParaView.

    paraview --script=view.py
    pvbatch view.py [--screenshot FILE.png]
"""

import argparse
import ctypes
import json
import os
import re
import sys

# The cell array `facet_kind` of extremal lines.
SEPARATING = 1
SUPPORTING = 3

# Number and name of every value of the cell arrays `region` and `discontinuity_order`.
REGIONS = [(0, "lit"), (1, "penumbra"), (2, "umbra"), (3, "unlit"), (4, "unresolved_eee")]
ORDERS = [(0, "D0"), (1, "D1"), (2, "D2")]


def end(message):
    """Ends with a sentence. ParaView's window has no other place for it than its messages."""
    raise SystemExit("view.py: " + message)


def paraview_simple():
    try:
        from paraview import simple
    except ImportError as error:
        end(f"ParaView's Python modules are missing ({error}); on Debian they are the package python3-paraview, and where "
            "libvtk9-dev keeps that from being installed, docs/paraview.md of gnomon says what to do")
    return simple


def require_display():
    """ParaView ends without a word where it draws by an X server and finds none."""
    from vtkmodules.vtkRenderingCore import vtkRenderWindow
    import vtkmodules.vtkRenderingOpenGL2
    if vtkRenderWindow().GetClassName() != "vtkXOpenGLRenderWindow":
        return
    x11 = ctypes.CDLL("libX11.so.6")
    x11.XOpenDisplay.restype = ctypes.c_void_p
    display = x11.XOpenDisplay(None)
    if not display:
        end("ParaView draws on a display and finds none; without a screen run "
            "`xvfb-run -a -s -noreset pvbatch view.py --screenshot FILE.png` (Debian packages xvfb and xauth)")
    # Left open: an X server that starts anew when its last client goes would do so just before ParaView comes.


def this_folder():
    """The folder of this file. ParaView's window runs scripts without __file__, but has the name on its command line."""
    if "__file__" in globals():
        return os.path.dirname(os.path.abspath(__file__))
    try:
        with open("/proc/self/cmdline", "rb") as command_line:
            words = [os.fsdecode(word) for word in command_line.read().split(b"\0")]
    except OSError:
        words = []
    for word, following in zip(words, words[1:]):
        name = word[len("--script="):] if word.startswith("--script=") else following
        if word.startswith("--script") and name.endswith(".py"):
            return os.path.dirname(os.path.abspath(name))
    return os.getcwd()


def read_manifest(folder):
    try:
        with open(os.path.join(folder, "manifest.json"), encoding="utf-8") as file:
            return json.load(file)
    except OSError as error:
        end(f"{error}; start ParaView in the result's folder, or with --script=FOLDER/view.py")


def root_file(folder, manifest):
    for root in manifest["roots"]:
        if root.endswith((".vtm", ".vtpc", ".pvd")):
            return os.path.join(folder, root)
    end("the result has no .vtm, .vtpc or .pvd file")


def generations_of(reader):
    """What the leaves say of the run that wrote them; none where they lie on another machine."""
    reader.UpdatePipeline()
    algorithm = reader.GetClientSideObject()
    data = algorithm.GetOutputDataObject(0) if algorithm else None
    found = set()
    if data is not None and data.IsA("vtkCompositeDataSet"):
        leaves = data.NewIterator()
        while not leaves.IsDoneWithTraversal():
            array = leaves.GetCurrentDataObject().GetFieldData().GetAbstractArray("generation")
            found.add(array.GetValue(0) if array else "")
            leaves.GoToNextItem()
    return found


def check_files(folder, manifest):
    """ParaView leaves out what is missing, and goes on."""
    for block in manifest["blocks"]:
        if block["file"] and not os.path.exists(os.path.join(folder, block["file"])):
            end(f"{block['file']} is missing; let gnomon write the folder again")


def check_generations(reader, manifest):
    """manifest.json takes its place last: leaves of another run are what a run that was stopped has left."""
    if "generation" in manifest:
        known = manifest.get("generations", [manifest["generation"]])
        if not generations_of(reader) <= set(known):
            end("some files are of another run than manifest.json; a run was stopped before it had put everything into "
                "its place, so let gnomon write the folder again")


def node(name):
    """How ParaView calls a block in its tree, where not every letter is allowed."""
    allowed = re.sub(r"[^A-Za-z0-9_.-]", "", name)
    return allowed if re.match(r"[A-Za-z_]", allowed) else "_" + allowed


class Result:
    """The result in the pipeline, part by part."""

    def __init__(self, reader, manifest, view):
        self.reader = reader
        self.blocks = [block for block in manifest["blocks"] if block["file"]]
        self.palette = manifest["palette"]
        self.up = manifest.get("up", "z")
        self.view = view
        with_results = {b["path"][1] for b in self.blocks if b["path"][0] != "scene"}
        names = [b["path"][-1] for b in self.blocks if b["kind"] == "light"]
        #: Those that have results: one is shown, for what several make of one place lies in one place.
        self.lights = [name for name in names if name in with_results] or names
        self.whole = {b["path"][-1] for b in self.blocks if b["kind"] == "blocker"}

    def select(self, kind, light=None, region=None):
        """The blocks of one kind, all or those of a light, all or those of a region."""
        return [b for b in self.blocks if b["kind"] == kind and light in (None, b["path"][1])
                and region in (None, b["path"][-1])]

    def suns(self):
        return [b for b in self.blocks if b["kind"] == "light" and b["field_data"]["shape"] == ["direction"]]

    def part(self, name, blocks):
        """The blocks under a name of their own; None if there are none."""
        if not blocks:
            return None
        extract = simple.ExtractBlock(registrationName=name, Input=self.reader)
        extract.Selectors = ["/Root/" + "/".join(node(part) for part in block["path"]) for block in blocks]
        extract.UpdatePipeline()
        return extract

    def show(self, source, color, opacity=1.0, edges=False):
        if source is None:
            return None
        display = simple.Show(source, self.view)
        display.Representation = "Surface With Edges" if edges else "Surface"
        display.ColorArrayName = [None, ""]
        display.AmbientColor = self.palette[color]
        display.DiffuseColor = self.palette[color]
        display.Ambient = 0.4
        display.Diffuse = 0.6
        display.EdgeColor = self.palette["edge"]
        display.Opacity = opacity
        display.LineWidth = 4.0
        display.PointSize = 16.0
        return display

    def color_by(self, display, array, flat=False):
        """By the numbers of an array, in the colours of the legend."""
        simple.ColorBy(display, ("CELLS", array))
        if flat:
            display.Ambient = 1.0
            display.Diffuse = 0.0

    def category_colors(self, array, entries):
        """Colours of an array of numbers that stand for names; they are those that a legend shows."""
        table = simple.GetColorTransferFunction(array)
        table.InterpretValuesAsCategories = 1
        table.Annotations = [text for number, name in entries for text in (str(number), name)]
        table.IndexedColors = [value for _, name in entries for value in self.palette[name]]
        table.IndexedOpacities = [1.0] * len(entries)
        return table

    def region_colors(self, names):
        return self.category_colors("region", [region for region in REGIONS if region[1] in names])


def only(source, name, facet_kind):
    """The cells of one kind."""
    facets = simple.Threshold(registrationName=name, Input=source)
    facets.Scalars = ["CELLS", "facet_kind"]
    facets.LowerThreshold = facet_kind
    facets.UpperThreshold = facet_kind
    return facets


def without(source, name, facet_kind):
    """The facets of other kinds: what lies on something else that is shown would flicker."""
    facets = only(source, name, facet_kind)
    facets.Invert = 1
    return facets


def show_volume(result, light, name, opacity, on_others):
    """Of blockers that are one convex body; those of parts are there to be switched on."""
    blocks = result.select("volume", light, name)
    source = result.part(name + " volumes", [b for b in blocks if b["path"][2] in result.whole])
    parts = result.part(name + " volumes of parts", [b for b in blocks if b["path"][2] not in result.whole])
    if parts is not None:
        result.color_by(result.show(parts, "edge", opacity), "region")
        simple.Hide(parts, result.view)
    if source is None:
        return None
    for facet_kind in on_others:
        source = without(source, f"{name} without facets of kind {facet_kind}", facet_kind)
    result.color_by(result.show(source, "edge", opacity), "region")
    return source


def set_camera(view, up):
    """A three-quarter view from above of everything that is shown."""
    toward = {"z": [0.5, -0.8, 0.42], "y": [0.5, 0.42, 0.8]}[up]
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraPosition = toward
    view.CameraViewUp = [0.0, float(up == "y"), float(up == "z")]
    simple.ResetCamera(view)


def new_view(edge):
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = [1280, 960]
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesLabelColor = edge
    return view


def show_legend(result, table, title="region", place="Lower Right Corner"):
    bar = simple.GetScalarBar(table, result.view)
    bar.Title = title
    bar.WindowLocation = place
    bar.ComponentTitle = ""
    bar.TitleColor = result.palette["edge"]
    bar.LabelColor = result.palette["edge"]
    bar.Visibility = 1


def show_by_order(result, name, source, opacity):
    """Surfaces or edges by the order of their discontinuity; a receiver's border has none and is left out."""
    events = simple.Threshold(registrationName=name + " by order", Input=source)
    events.Scalars = ["CELLS", "discontinuity_order"]
    events.LowerThreshold = 0
    events.UpperThreshold = 2
    result.color_by(result.show(events, "edge", opacity), "discontinuity_order")
    return events


def show_fronts_and_backs(result, light, fronts, is_shown):
    """Receivers by their regions from the front, with which they receive, and grey from behind."""
    display = result.show(fronts, "edge")
    result.color_by(display, "region", flat=True)
    display.BackfaceRepresentation = "Cull Backface"
    backs = result.part(f"backs of receivers of {light}", result.select("receiver_faces", light))
    result.show(backs, "receiver").BackfaceRepresentation = "Cull Frontface"
    if not is_shown:
        simple.Hide(backs, result.view)


def show_divisions(result):
    """Discontinuities by their order, divided receivers by their regions; those of other lights than the first are there
    to be switched on."""
    order = result.category_colors("discontinuity_order", ORDERS)
    for kind, opacity in (("discontinuities", 0.5), ("receiver_faces", 1.0), ("receiver_edges", 1.0)):
        for i, light in enumerate(result.lights):
            name = f"{kind.replace('_', ' ')} of {light}"
            source = result.part(name, [b for b in result.select(kind, light) if "discontinuity_order" in b["cell_arrays"]
                                        or kind == "receiver_faces"])
            if source is None:
                continue
            if kind == "receiver_faces":
                show_fronts_and_backs(result, light, source, is_shown=i == 0)
            else:
                source = show_by_order(result, name, source, opacity)
                show_legend(result, order, "order", "Upper Right Corner")
            if i > 0:
                simple.Hide(source, result.view)


def show_illumination(result):
    """Meshes of receivers by the irradiance at their points, their discontinuities there to be switched on."""
    source = result.part("illumination", result.select("illumination"))
    if source is None:
        return
    display = result.show(source, "edge")
    simple.ColorBy(display, ("POINTS", "irradiance"))
    display.RescaleTransferFunctionToDataRange(False)
    display.Ambient = 1.0
    display.Diffuse = 0.0
    table = simple.GetColorTransferFunction("irradiance")
    table.ApplyPreset("Inferno (matplotlib)", True)
    show_legend(result, table, "irradiance [W/m^2]")
    lines = result.part("discontinuities of illumination", result.select("illumination_edges"))
    if lines is not None:
        result.show(lines, "edge").LineWidth = 1.0
        simple.Hide(lines, result.view)


def show_hidden(result, light):
    """What is there to be switched on."""
    others = [b for b in result.select("volume") if b["path"][1] != light]
    for hidden in (result.part("occlusion volumes", result.select("volume", light, "occlusion")),
                   result.part("extremal planes", result.select("extremal_planes", light)),
                   result.part("volumes of other lights", others),
                   result.part("other lights", [b for b in result.select("light") if b["path"][-1] != light])):
        if hidden is not None:
            result.show(hidden, "plane", 0.3, edges=True)
            simple.Hide(hidden, result.view)


def bounds(result, block):
    part = result.part("bounds", [block])
    found = part.GetDataInformation().GetBounds()
    simple.Delete(part)
    return found


def meshed_blockers(result):
    """Blockers with a meshed facet: the two lie in one place and would flicker."""
    blockers, sides = result.select("blocker"), result.select("illumination")
    if not sides or len(blockers) * len(sides) > 10000:
        return []
    inner = [bounds(result, side) for side in sides]
    found = []
    for blocker in blockers:
        b = bounds(result, blocker)
        if any(all(i[k] >= b[k] and i[k + 1] <= b[k + 1] for k in (0, 2, 4)) for i in inner):
            found.append(blocker)
    return found


def show_blockers(result, divided):
    """What is a divided receiver, too, is there to be switched on: the two lie in one place and would flicker."""
    facets = {b["path"][-1]: b["kind"] == "receiver" for b in result.select("receiver") + result.select("receiver_mesh")}
    covered = [b for b in result.select("blocker") if b["path"][-1] in divided
               and facets.get(b["path"][-1]) == (b["field_data"]["shape"] == ["polygon"])]
    covered += [b for b in meshed_blockers(result) if b not in covered]
    result.show(result.part("blockers", [b for b in result.select("blocker") if b not in covered]), "blocker", edges=True)
    hidden = result.part("blockers that are divided receivers", covered)
    if hidden is not None:
        result.show(hidden, "blocker", edges=True)
        simple.Hide(hidden, result.view)


def show_space(result):
    """Returns the names of the regions shown."""
    light = result.lights[0] if result.lights else None
    lamp = [b for b in result.select("light") if b["path"][-1] == light]
    suns = [b for b in lamp if b in result.suns()]
    result.show(result.part("light " + str(light), [b for b in lamp if b not in suns]), "light", edges=True)
    meshed = {b["path"][1].split("/")[0] for b in result.select("illumination")}
    divided = {b["path"][2] for b in result.select("receiver_faces", light)} | meshed
    show_blockers(result, divided)
    receivers = result.select("receiver") + result.select("receiver_mesh")
    plain = [b for b in receivers if b["path"][-1] not in divided]
    result.show(result.part("receivers", plain), "receiver", edges=True)
    borders = result.show(result.part("borders of receivers", [b for b in receivers if b not in plain]), "edge")
    if borders is not None:
        borders.Representation = "Feature Edges"
        borders.LineWidth = 1.5
    # Blocker faces lie on the blockers, a penumbra's supporting planes on the umbra.
    umbrae = show_volume(result, light, "umbra", 0.55, (0,))
    penumbrae = show_volume(result, light, "penumbra", 0.3, (0, 3))
    show_divisions(result)
    show_illumination(result)
    show_hidden(result, light)
    set_camera(result.view, result.up)
    result.show(result.part("sun " + str(light), suns), "light")  # an arrow beside the scene, which frames nothing
    if meshed:
        return []
    if divided:
        return [name for _, name in REGIONS if name != "unresolved_eee"]
    return [name for name, source in (("umbra", umbrae), ("penumbra", penumbrae)) if source is not None]


class Drawing:
    """A result of the plane as paper: every layer lies a little above the one before, for what lies on something else
    would flicker."""

    def __init__(self, result, box):
        self.result = result
        self.box = box
        self.light = result.lights[0] if result.lights else None
        self.step = 1e-3 * max(box[3] - box[0], box[4] - box[1])
        self.layer = 0

    def show(self, source, color, line_width=4.0):
        if source is None:
            return None
        display = self.result.show(source, color)
        display.Ambient = 1.0
        display.Diffuse = 0.0
        display.LineWidth = line_width
        self.layer += 1
        display.Position = [0.0, 0.0, self.layer * self.step]
        return display

    def show_region(self, name):
        kind = "region" if self.result.select("region") else "volume"
        display = self.show(self.result.part(name + " regions", self.result.select(kind, self.light, name)), "edge")
        if display is not None:
            simple.ColorBy(display, ("CELLS", "region"))
        return display is not None

    def show_lines(self):
        lines = (self.result.part("boundaries", self.result.select("boundaries", self.light)) or
                 self.result.part("extremal lines", self.result.select("extremal_planes", self.light)))
        if lines is None:
            return
        for name, kind in (("supporting", SUPPORTING), ("separating", SEPARATING)):
            self.show(only(lines, name + " lines", kind), name, line_width=2.0)

    def set_camera(self):
        view = self.result.view
        x, y = [(self.box[i] + self.box[i + 3]) / 2 for i in range(2)]
        half_width, half_height = [(self.box[i + 3] - self.box[i]) / 2 for i in range(2)]
        width, height = view.ViewSize
        scale = max(half_height, half_width * height / width)
        view.InteractionMode = "2D"
        simple.Render(view)  # the first rendering chooses a camera of its own
        view.CameraParallelProjection = 1
        view.CameraFocalPoint = [x, y, 0.0]
        view.CameraPosition = [x, y, 4.0 * scale]
        view.CameraViewUp = [0.0, 1.0, 0.0]
        view.CameraParallelScale = 1.25 * scale  # room for the legend


def show_plane(result, box):
    """Returns the names of the regions shown."""
    drawing = Drawing(result, box)
    names = [name for name in ("penumbra", "umbra") if drawing.show_region(name)]
    drawing.show_lines()
    drawing.show(result.part("receivers", result.select("receiver") + result.select("receiver_mesh")), "plane")
    drawing.show(result.part("blockers", result.select("blocker")), "blocker", line_width=6.0)
    lamp = [b for b in result.select("light") if b["path"][-1] == drawing.light]
    drawing.show(result.part("light " + str(drawing.light), lamp), "light", line_width=6.0)
    drawing.set_camera()
    return names


PICTURE_ENDINGS = (".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".ppm")


def save_picture(path, view):
    """ParaView tells a wrong reason where a folder is missing, or none, and goes on."""
    try:
        os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
        open(path, "ab").close()
    except OSError as error:
        end(f"the picture cannot be written: {error}")
    simple.SaveScreenshot(path, view, ImageResolution=[1280, 960])


def main(arguments):
    parser = argparse.ArgumentParser(prog="view.py", description="shows the result beside this file")
    parser.add_argument("--screenshot", metavar="FILE.png", help="write a picture and end")
    options = parser.parse_args(arguments)
    if options.screenshot and not options.screenshot.lower().endswith(PICTURE_ENDINGS):
        end(f"{options.screenshot}: expected a picture's ending, one of {', '.join(PICTURE_ENDINGS)}")

    folder = this_folder()
    manifest = read_manifest(folder)
    file = root_file(folder, manifest)
    check_files(folder, manifest)
    reader = simple.OpenDataFile(file, registrationName=os.path.basename(file))
    check_generations(reader, manifest)
    view = new_view(manifest["palette"]["edge"])
    simple.Hide(reader, view)

    result = Result(reader, manifest, view)
    if manifest["dimension"] == 2:
        names = show_plane(result, manifest["field_data"]["clip_box"])
    else:
        names = show_space(result)
    if names:
        show_legend(result, result.region_colors(names))
    if file.endswith(".pvd"):
        simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    simple.Render(view)
    if options.screenshot:
        save_picture(options.screenshot, view)


simple = paraview_simple()
require_display()
main(sys.argv[1:] if "__file__" in globals() else [])
