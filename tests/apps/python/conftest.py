"""What several tests need: the example scenes, the built program, and its tables as arrays."""

import csv
import io
import os
import pathlib
import subprocess

import pytest

import gnomon

EXAMPLES = pathlib.Path(os.environ["GNOMON_EXAMPLES"])
PROGRAM = os.environ["GNOMON_PROGRAM"]
CASES = 5000 if os.environ.get("GNOMON_LONG_TESTS") == "ON" else 200


def run_program(*arguments: str, text: str = "") -> str:
    """What the program prints."""
    run = subprocess.run([PROGRAM, *arguments], input=text, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    return run.stdout


def program_table(*arguments: str, text: str = "") -> list[dict[str, str]]:
    """The rows that the program prints."""
    return list(csv.DictReader(io.StringIO(run_program(*arguments, text=text))))


@pytest.fixture
def lamp_and_table() -> gnomon.Scene:
    """A square lamp above a square table."""
    scene = gnomon.Scene()
    scene.add_light("lamp", [[-1, -1, 4], [-1, 1, 4], [1, 1, 4], [1, -1, 4]], radiance=100)
    scene.add_blocker("table", [[-1, -1, 2], [1, -1, 2], [1, 1, 2], [-1, 1, 2]])
    scene.add_receiver("floor", [[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0]])
    return scene
