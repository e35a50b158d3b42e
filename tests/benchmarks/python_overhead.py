"""What asking from Python costs: python_overhead.py BASELINE SCENE [POINTS]

Prints the time of a call beside that of the same question in C++, and a million points (or so many) beside the library's
own loop, both on one thread, the better of some runs that take turns. Nothing passes or fails by the time it takes.
"""

import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np

import gnomon

RUNS = 5
CALLS = 100_000


def python_times(scene: gnomon.Scene, points: np.ndarray, normals: np.ndarray) -> tuple[float, float, float]:
    """Seconds for all points, microseconds of a call, and the sum of the irradiances."""
    start = time.perf_counter()
    found = scene.irradiance(points, normals, threads=1)
    seconds = time.perf_counter() - start
    one, up = points[:1].copy(), normals[:1].copy()
    start = time.perf_counter()
    for _ in range(CALLS):
        scene.irradiance(one, up)
    call = (time.perf_counter() - start) / CALLS * 1e6
    total = 0.0
    for value in found.irradiance.ravel():
        total += value
    return seconds, call, total


def main(baseline: str, file: str, count: str = "1000000") -> None:
    """Measures, and prints both ratios."""
    scene = gnomon.Scene.read(file)
    print("seed 1")
    points = np.random.default_rng(1).uniform(-4, 4, (int(count), 3))
    points[:, 2] = 0
    normals = np.tile([0.0, 0.0, 1.0], (len(points), 1))
    ours, theirs = [], []
    with tempfile.TemporaryDirectory() as folder:
        sensors = pathlib.Path(folder, "sensors")
        np.hstack([points, normals]).tofile(sensors)
        for _ in range(RUNS):
            told = subprocess.check_output([baseline, file, str(sensors)], text=True)
            theirs.append([float(word) for word in told.split()])
            ours.append(python_times(scene, points, normals))
    if {row[2] for row in ours} != {row[2] for row in theirs}:
        sys.exit("python_overhead.py: Python and C++ have different answers")
    (seconds, call), (seconds_cpp, call_cpp) = (np.array(rows)[:, :2].min(axis=0) for rows in (ours, theirs))
    print(f"a call: {call:.2f} us, in C++ {call_cpp:.2f} us: overhead {call - call_cpp:.2f} us")
    print(f"{count} points: {seconds:.3f} s, in C++ {seconds_cpp:.3f} s: ratio {seconds / seconds_cpp:.3f}")


main(*sys.argv[1:])
