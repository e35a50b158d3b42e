"""Makes the pictures of docs/paraview.md: pvbatch paraview_pictures.py [FOLDER]

FOLDER (by default this one) gets them. Needs, in the current folder, what the page's commands have written: `out` of
`gnomon shadow`, `floor.vti` and `two.vti` of `gnomon grid`.
"""

import json
import os
import sys

from paraview import simple

if not os.environ.get("DISPLAY"):
    # ParaView ends with a stack trace where it finds no display.
    raise SystemExit("paraview_pictures.py: ParaView draws on a display and DISPLAY is not set; without a screen run "
                     "`xvfb-run -a -s -noreset pvbatch paraview_pictures.py` (Debian packages xvfb and xauth)")

EDGE = [0.12, 0.12, 0.14]
RECEIVER = [0.82, 0.82, 0.83]
FRACTION = [0.0, 0.07, 0.22, 0.42, 0.5, 0.47, 0.71, 0.89, 1.0, 1.0, 0.97, 0.86]


def new_view(position, focus, parallel=False):
    view = simple.CreateView("RenderView")
    view.ViewSize = [960, 640]
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesVisibility = 0
    view.CameraPosition = position
    view.CameraFocalPoint = focus
    view.CameraViewUp = [0.0, 0.0, 1.0] if not parallel else [0.0, 1.0, 0.0]
    view.CameraParallelProjection = int(parallel)
    return view


def save(view, folder, name):
    simple.Render(view)
    simple.SaveScreenshot(os.path.join(folder, name), view, ImageResolution=[960, 640])


def flat(display):
    """Colours as they are, whatever the light of the view."""
    display.Ambient = 1.0
    display.Diffuse = 0.0
    return display


def frame(view, zoom=1.25):
    view.ResetCamera(False)
    view.GetActiveCamera().Zoom(zoom)


def show(source, view, color, opacity=1.0):
    display = flat(simple.Show(source, view))
    display.ColorArrayName = [None, ""]
    display.AmbientColor = display.DiffuseColor = color
    display.Opacity = opacity
    return display


def block(reader, selector):
    return simple.ExtractBlock(Input=reader, Selectors=[selector])


def slice_of(source, origin, normal):
    cut = simple.Slice(Input=source)
    cut.SliceType.Origin = origin
    cut.SliceType.Normal = normal
    return cut


def sliced_penumbra(folder):
    """The solid penumbra and umbra cut by an upright plane."""
    reader = simple.OpenDataFile("out/shadow.vtm")
    view = new_view([4.0, -14.0, 6.0], [0.0, 0.0, 1.8])
    show(block(reader, "//scene/blockers"), view, [0.84, 0.37, 0.0])
    show(block(reader, "//scene/lights"), view, [0.94, 0.76, 0.05])
    show(block(reader, "//scene/receivers"), view, RECEIVER)
    show(block(reader, "//volumes/*/*/penumbra"), view, [0.47, 0.71, 0.89], 0.15)
    for name, color in (("penumbra", [0.47, 0.71, 0.89]), ("umbra", [0.07, 0.22, 0.42])):
        cut = slice_of(block(reader, f"//solids/*/*/{name}"), [0.0, 0.0, 1.0], [0.0, 1.0, 0.0])
        show(cut, view, color)
    frame(view)
    save(view, folder, "paraview_slice.png")


def colored_by_fraction(source, view, array):
    display = flat(simple.Show(source, view))
    display.Representation = "Surface"
    simple.ColorBy(display, ("POINTS", array))
    table = simple.GetColorTransferFunction(array)
    table.ColorSpace = "RGB"
    table.RGBPoints = FRACTION
    bar = simple.GetScalarBar(table, view)
    bar.Title = "visible fraction"
    bar.ComponentTitle = ""
    bar.TitleColor = bar.LabelColor = EDGE
    bar.Visibility = 1
    return display


def receiver_by_fraction(folder):
    """The floor, coloured by how much of the lamp is seen there."""
    view = new_view([0.0, 0.0, 30.0], [0.0, 0.0, 0.0], parallel=True)
    colored_by_fraction(simple.OpenDataFile("floor.vti"), view, "visible_fraction")
    frame(view)
    save(view, folder, "paraview_fraction.png")


def two_lights(folder):
    """Where two lamps differ: the visible fraction of one less that of the other."""
    view = new_view([0.0, 0.0, 30.0], [0.0, 0.0, 0.0], parallel=True)
    both = simple.OpenDataFile("two.vti")
    difference = simple.Calculator(Input=both)
    difference.ResultArrayName = "left_minus_right"
    difference.Function = '"visible_fraction_left" - "visible_fraction_right"'
    display = flat(simple.Show(difference, view))
    display.Representation = "Surface"
    simple.ColorBy(display, ("POINTS", "left_minus_right"))
    table = simple.GetColorTransferFunction("left_minus_right")
    table.ColorSpace = "RGB"
    table.RGBPoints = [-1.0, 0.84, 0.37, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0, 0.07, 0.22, 0.42]
    bar = simple.GetScalarBar(table, view)
    bar.Title = "left minus right"
    bar.ComponentTitle = ""
    bar.TitleColor = bar.LabelColor = EDGE
    bar.Visibility = 1
    frame(view)
    save(view, folder, "paraview_two_lights.png")


def main(folder="."):
    sliced_penumbra(folder)
    receiver_by_fraction(folder)
    two_lights(folder)
    print("written", json.dumps(sorted(name for name in os.listdir(folder) if name.startswith("paraview_"))))


main(*sys.argv[1:])
