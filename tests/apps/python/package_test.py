"""pip installs the package from the sources, and asks nobody for anything."""

import csv
import importlib.util
import os
import pathlib
import subprocess
import sys
import zipfile

import pytest

ROOT = pathlib.Path(os.environ["GNOMON_EXAMPLES"]).parent

pytestmark = pytest.mark.skipif("GNOMON_BUILD_DIR" not in os.environ, reason="no build folder is named")


def test_pip_installs_what_runs_elsewhere(tmp_path):
    if importlib.util.find_spec("pip") is None:
        pytest.skip("pip is not there")
    options = ["--quiet", "--no-index", "--no-deps", "--disable-pip-version-check", "--root-user-action=ignore"]
    target = tmp_path / "site"
    install = [sys.executable, "-m", "pip", "install", *options, "--target", str(target), str(ROOT)]
    run = subprocess.run(install, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stdout + run.stderr
    program = "import gnomon; print(gnomon.__file__, gnomon.__version__, gnomon.Scene().regions([[0, 0, 0]]).region.shape)"
    environment = {**os.environ, "PYTHONPATH": str(target)}
    told = subprocess.check_output([sys.executable, "-c", program], text=True, env=environment, cwd=tmp_path)
    assert told.split()[0] == str(target / "gnomon" / "__init__.py")
    assert told.split()[2:] == ["(1,", "0)"]


def test_the_wheel_lists_all_its_files(tmp_path):
    call = f"import sys; sys.path.insert(0, {str(ROOT / 'apps/python')!r}); import build_backend; print(build_backend.build_wheel('.'))"
    told = subprocess.check_output([sys.executable, "-B", "-c", call], text=True, cwd=tmp_path)
    with zipfile.ZipFile(tmp_path / told.splitlines()[-1]) as wheel:
        names = wheel.namelist()
        assert wheel.testzip() is None
        (record,) = [name for name in names if name.endswith("/RECORD")]
        listed = [row[0] for row in csv.reader(wheel.read(record).decode().splitlines())]
        assert sorted(listed) == sorted(names)
        sources = {f"gnomon/{path.name}" for path in (ROOT / "apps/python/gnomon").iterdir() if path.is_file()}
        assert sources <= set(names)
