"""The statements of the theory, checked by the program gnomon-proof."""

import json
import os
import pathlib
import shutil
import subprocess
import tempfile
from collections.abc import Iterable
from typing import Any

from gnomon.errors import ArgumentError, Error, UnsupportedError

_PROGRAM = "gnomon-proof"


def _program() -> str:
    """On the path; beside what is installed, or built, with this package."""
    package = pathlib.Path(__file__).resolve().parent
    beside = [str(folder / "bin") for folder in package.parents[1:4]]
    found = shutil.which(_PROGRAM, path=os.pathsep.join([os.environ.get("PATH", ""), *beside]))
    if found is None:
        raise UnsupportedError(
            "theorems are checked by gnomon-proof, which is neither on the path nor beside this package; "
            "it is in the Debian package gnomon-proof, or built with -DGNOMON_PROOF=ON"
        )
    return found


def theorems(*, only: Iterable[str] = (), cases: int = 1000, seed: int = 1) -> dict[str, Any]:
    """Checks the statements that the package rests on, on random and on nearly degenerate cases.

    only: keys of statements, as ["S4", "F1"]; all without it. cases: of every statement, half of them nearly degenerate.
    seed: the cases are the same for the same seed.
    Returns what `gnomon theorems --json` tells, a dictionary of schema gnomon/theorems/1. A statement that fails has
    the status "fails"; no files are written. Raises UnsupportedError where gnomon-proof is not there, ArgumentError with
    its sentence for arguments that make no sense.
    """
    keys = ",".join(only)
    options = ["--cases", str(cases), "--seed", str(seed), "--json", "-", *(["--only", keys] if keys else [])]
    with tempfile.TemporaryDirectory() as folder:
        command = [_program(), "theorems", *options]
        run = subprocess.run(command, capture_output=True, text=True, check=False, cwd=folder)
    if run.returncode == 2:
        raise ArgumentError(run.stderr.splitlines()[0].removeprefix("gnomon: ").removeprefix("--"))
    if not run.stdout:
        raise Error(run.stderr.strip())
    result: dict[str, Any] = json.loads(run.stdout)
    return result
