"""Shows the result that lies beside this file in ParaView.

    paraview --script=view.py
    pvbatch view.py [--screenshot FILE.png]
"""

import argparse
import json
import os
import sys

from paraview import simple

LIGHT = [0.94, 0.76, 0.05]
BLOCKER = [0.84, 0.37, 0.00]
RECEIVER = [0.95, 0.93, 0.87]
EDGE = [0.12, 0.12, 0.14]
PLANE = [0.45, 0.45, 0.50]

# The cell array `facet_kind` of extremal lines.
SEPARATING = (1, [0.72, 0.11, 0.42])
SUPPORTING = (3, [0.00, 0.43, 0.26])

# Number, name and colour of every value of the cell array `region`.
REGIONS = [
    (0, "lit", [0.98, 0.91, 0.62]),
    (1, "penumbra", [0.47, 0.71, 0.89]),
    (2, "umbra", [0.07, 0.22, 0.42]),
    (3, "unlit", [0.35, 0.33, 0.36]),
    (4, "unresolved_eee", [0.80, 0.47, 0.65]),
]


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
        raise SystemExit(f"view.py: {error}; start ParaView in the result's folder, or with --script=FOLDER/view.py")


def root_file(folder, manifest):
    for root in manifest["roots"]:
        if root.endswith((".vtm", ".vtpc", ".pvd")):
            return os.path.join(folder, root)
    raise SystemExit("view.py: the result has no .vtm, .vtpc or .pvd file")


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


def check_generations(reader, manifest):
    """manifest.json takes its place last: leaves of another run are what a run that was stopped has left."""
    if "generation" in manifest:
        known = manifest.get("generations", [manifest["generation"]])
        if not generations_of(reader) <= set(known):
            raise SystemExit("view.py: some files are of another run than manifest.json; a run was stopped before it "
                             "had put everything into its place, so let gnomon write the folder again")


# The same for `discontinuity_order`: where the light jumps, its first derivative does, or its second.
ORDERS = [
    (0, "D0", [0.20, 0.00, 0.05]),
    (1, "D1", [0.85, 0.08, 0.35]),
    (2, "D2", [0.48, 0.92, 0.48]),
]


class Result:
    """The result in the pipeline, part by part."""

    def __init__(self, reader, manifest, view):
        self.reader = reader
        self.blocks = manifest["blocks"]
        self.view = view

    def part(self, name, kind, region=None):
        """The blocks of one kind under a name of their own; None if there are none."""
        if not any(b["kind"] == kind and b["file"] and region in (None, b["path"][-1]) for b in self.blocks):
            return None
        folder = {"light": "scene/lights", "blocker": "scene/blockers", "receiver": "scene/receivers",
                  "volume": "volumes", "extremal_planes": "extremal_planes", "region": "regions",
                  "boundaries": "boundaries"}[kind]
        extract = simple.ExtractBlock(registrationName=name, Input=self.reader)
        extract.Selectors = ["//" + folder if region is None else f"//{folder}/*/*/{region}"]
        extract.UpdatePipeline()
        return extract

    def lights_of(self, kind):
        """The lights, in order, that have blocks of a kind."""
        return list(dict.fromkeys(b["path"][1] for b in self.blocks if b["kind"] == kind and b["file"]))

    def of_light(self, light, kind):
        """All blocks of one kind and light."""
        paths = ["/".join(b["path"]) for b in self.blocks
                 if b["kind"] == kind and b["file"] and b["path"][1] == light]
        extract = simple.ExtractBlock(registrationName=f"{kind.replace('_', ' ')} of {light}", Input=self.reader)
        extract.Selectors = ["/Root/" + path for path in paths]
        extract.UpdatePipeline()
        return extract

    def show(self, source, color, opacity=1.0, edges=False):
        if source is None:
            return None
        display = simple.Show(source, self.view)
        display.Representation = "Surface With Edges" if edges else "Surface"
        display.ColorArrayName = [None, ""]
        display.AmbientColor = color
        display.DiffuseColor = color
        display.Ambient = 0.4
        display.Diffuse = 0.6
        display.EdgeColor = EDGE
        display.Opacity = opacity
        display.LineWidth = 4.0
        display.PointSize = 16.0
        return display


def category_colors(array, entries):
    """Colours of an array of numbers that stand for names; they are those that a legend shows."""
    table = simple.GetColorTransferFunction(array)
    table.InterpretValuesAsCategories = 1
    table.Annotations = [text for number, name, _ in entries for text in (str(number), name)]
    table.IndexedColors = [value for _, _, color in entries for value in color]
    table.IndexedOpacities = [1.0] * len(entries)
    return table


def region_colors(names):
    return category_colors("region", [region for region in REGIONS if region[1] in names])


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


def show_volume(result, name, opacity, on_others):
    source = result.part(name + " volumes", "volume", name)
    if source is None:
        return None
    for facet_kind in on_others:
        source = without(source, f"{name} without facets of kind {facet_kind}", facet_kind)
    display = result.show(source, EDGE, opacity)
    simple.ColorBy(display, ("CELLS", "region"))
    return source


def middle(bounds):
    return [(bounds[2 * i] + bounds[2 * i + 1]) / 2 for i in range(3)]


def up_axis(lights, blockers):
    """The axis that leads from the blockers to the lights; z where it is close."""
    if lights is None or blockers is None:
        return [0.0, 0.0, 1.0]
    low = middle(blockers.GetDataInformation().GetBounds())
    high = middle(lights.GetDataInformation().GetBounds())
    way = [h - l for h, l in zip(high, low)]
    length = max(1e-300, sum(x * x for x in way) ** 0.5)
    axis = 2 if abs(way[2]) >= 0.5 * length else max(range(3), key=lambda i: abs(way[i]))
    up = [0.0, 0.0, 0.0]
    up[axis] = 1.0 if way[axis] >= 0 else -1.0
    return up


def set_camera(view, up):
    """A three-quarter view from above."""
    axis = max(range(3), key=lambda i: abs(up[i]))
    position = [0.0, 0.0, 0.0]
    position[(axis + 1) % 3] = 0.5
    position[(axis + 2) % 3] = -0.8
    position[axis] = 0.42 * up[axis]
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraPosition = position
    view.CameraViewUp = up
    simple.ResetCamera(view)
    view.GetActiveCamera().Zoom(1.2)


def new_view():
    view = simple.GetActiveViewOrCreate("RenderView")
    view.ViewSize = [1280, 960]
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesLabelColor = EDGE
    return view


def show_legend(view, table, title="region", place="Lower Right Corner"):
    bar = simple.GetScalarBar(table, view)
    bar.Title = title
    bar.WindowLocation = place
    bar.ComponentTitle = ""
    bar.TitleColor = EDGE
    bar.LabelColor = EDGE
    bar.Visibility = 1


def show_by_order(result, name, source, opacity):
    """Surfaces or edges by the order of their discontinuity; a receiver's border has none and is left out."""
    events = simple.Threshold(registrationName=name + " by order", Input=source)
    events.Scalars = ["CELLS", "discontinuity_order"]
    events.LowerThreshold = 0
    events.UpperThreshold = 2
    simple.ColorBy(result.show(events, EDGE, opacity), ("CELLS", "discontinuity_order"))
    return events


def show_divisions(result):
    """Discontinuities by their order, divided receivers by their regions: those of the first light, for what lights
    make of one receiver lies in one place. The others are there to be switched on."""
    order = category_colors("discontinuity_order", ORDERS)
    for kind, opacity in (("discontinuities", 0.5), ("receiver_faces", 1.0), ("receiver_edges", 1.0)):
        for i, light in enumerate(result.lights_of(kind)):
            source = result.of_light(light, kind)
            if kind == "receiver_faces":
                simple.ColorBy(result.show(source, EDGE), ("CELLS", "region"))
            else:
                source = show_by_order(result, f"{kind} of {light}", source, opacity)
                show_legend(result.view, order, "order", "Upper Right Corner")
            if i > 0:
                simple.Hide(source, result.view)


def show_space(result):
    """Returns the names of the regions shown."""
    lights = result.part("lights", "light")
    blockers = result.part("blockers", "blocker")
    result.show(lights, LIGHT, edges=True)
    result.show(blockers, BLOCKER, edges=True)
    divided = bool(result.lights_of("receiver_faces"))
    receivers = result.part("receivers", "receiver")
    result.show(receivers, RECEIVER, edges=True)
    if divided:
        simple.Hide(receivers, result.view)  # the faces lie on them
    # Blocker faces lie on the blockers, a penumbra's supporting planes on the umbra.
    umbrae = show_volume(result, "umbra", 0.55, (0,))
    penumbrae = show_volume(result, "penumbra", 0.3, (0, 3))

    show_divisions(result)

    # There to be switched on.
    for hidden in (result.part("occlusion volumes", "volume", "occlusion"),
                   result.part("extremal planes", "extremal_planes")):
        if hidden is not None:
            result.show(hidden, PLANE, 0.3, edges=True)
            simple.Hide(hidden, result.view)

    set_camera(result.view, up_axis(lights, blockers))
    if divided:
        return [name for _, name, _ in REGIONS]
    return [name for name, source in (("umbra", umbrae), ("penumbra", penumbrae)) if source is not None]


class Drawing:
    """A result of the plane as paper: every layer lies a little above the one before, for what lies on something else
    would flicker."""

    def __init__(self, result, box):
        self.result = result
        self.box = box
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
        kind = "region" if any(b["kind"] == "region" for b in self.result.blocks) else "volume"
        display = self.show(self.result.part(name + " regions", kind, name), EDGE)
        if display is not None:
            simple.ColorBy(display, ("CELLS", "region"))
        return display is not None

    def show_lines(self):
        lines = self.result.part("boundaries", "boundaries") or self.result.part("extremal lines", "extremal_planes")
        if lines is None:
            return
        for name, (kind, color) in (("supporting lines", SUPPORTING), ("separating lines", SEPARATING)):
            self.show(only(lines, name, kind), color, line_width=2.0)

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
    drawing.show(result.part("receivers", "receiver"), PLANE)
    drawing.show(result.part("blockers", "blocker"), BLOCKER, line_width=6.0)
    drawing.show(result.part("lights", "light"), LIGHT, line_width=6.0)
    drawing.set_camera()
    return names


def main(arguments):
    parser = argparse.ArgumentParser(prog="view.py", description="shows the result beside this file")
    parser.add_argument("--screenshot", metavar="FILE.png", help="write a picture and end")
    options = parser.parse_args(arguments)

    folder = this_folder()
    manifest = read_manifest(folder)
    file = root_file(folder, manifest)
    reader = simple.OpenDataFile(file, registrationName=os.path.basename(file))
    check_generations(reader, manifest)
    view = new_view()
    simple.Hide(reader, view)

    result = Result(reader, manifest, view)
    if manifest["dimension"] == 2:
        names = show_plane(result, manifest["field_data"]["clip_box"])
    else:
        names = show_space(result)
    if names:
        show_legend(view, region_colors(names))
    if file.endswith(".pvd"):
        simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    simple.Render(view)
    if options.screenshot:
        simple.SaveScreenshot(options.screenshot, view, ImageResolution=[1280, 960])


main(sys.argv[1:] if "__file__" in globals() else [])
