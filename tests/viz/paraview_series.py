"""Plays a series: pvbatch paraview_series.py FOLDER PATH.csv; the path is the one that the series was made of.

Checks the times, that the light is where it ought to be at each of them, and that view.py makes a picture.
"""

import os
import runpy
import sys
import tempfile

from paraview import simple


def light_corner(reader, time):
    """The first point of the light at a time."""
    light = simple.ExtractBlock(Input=reader, Selectors=["//scene/lights"])
    light.UpdatePipeline(time)
    data = light.GetClientSideObject().GetOutputDataObject(0)
    iterator = data.NewIterator()
    iterator.InitTraversal()
    return iterator.GetCurrentDataObject().GetPoint(0)


def main(folder, positions):
    reader = simple.OpenDataFile(os.path.join(folder, "shadow.pvd"))
    reader.UpdatePipelineInformation()
    times = [float(time) for time in reader.TimestepValues]
    if times != [float(i) for i in range(len(positions))]:
        sys.exit(f"times: found {times}, expected {len(positions)} from 0")
    for time, position in zip(times, positions):
        found = light_corner(reader, time)
        if found != position:
            sys.exit(f"light at time {time}: found {found}, expected {position}")
    with tempfile.TemporaryDirectory() as temporary:
        picture = os.path.join(temporary, "view.png")
        sys.argv = ["view.py", "--screenshot", picture]
        runpy.run_path(os.path.join(folder, "view.py"), run_name="__main__")
        if os.path.getsize(picture) < 10000:
            sys.exit("view.py: the picture of the series is blank")
    print("played:", len(times), "times")


def positions_in(path):
    with open(path, encoding="utf-8") as file:
        return [tuple(float(x) for x in line.split(",")) for line in file.read().split()[1:]]


main(sys.argv[1], positions_in(sys.argv[2]))
