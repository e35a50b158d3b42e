"""What pip asks to build a wheel (PEP 517): CMake builds the module. Nothing is downloaded.

GNOMON_BUILD_DIR names a build folder of one's own that has GNOMON_PYTHON; otherwise build/wheel is made.
"""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import zipfile
from typing import Any

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGES = "lib/python3/dist-packages"

Settings = dict[str, Any] | None


def _version() -> str:
    found = re.search(r"^project\(gnomon VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(), re.MULTILINE)
    if found is None:
        sys.exit("CMakeLists.txt: found no version of the project")
    return found[1]


def _tag() -> str:
    interpreter = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{interpreter}-{interpreter}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def _build(prefix: str) -> None:
    folder = os.environ.get("GNOMON_BUILD_DIR")
    if folder is None:
        folder = str(ROOT / "build" / "wheel")
        options = ["-DCMAKE_BUILD_TYPE=Release", "-DBUILD_TESTING=OFF", "-DGNOMON_PYTHON=ON"]
        python = f"-DPython3_EXECUTABLE={sys.executable}"
        subprocess.run(["cmake", "-S", str(ROOT), "-B", folder, *options, python], check=True)
    environment = {"CMAKE_BUILD_PARALLEL_LEVEL": str(os.cpu_count()), **os.environ}
    subprocess.run(["cmake", "--build", folder, "--target", "gnomon_python"], check=True, env=environment)
    subprocess.run(["cmake", "--install", folder, "--component", "python", "--prefix", prefix], check=True)


def _metadata() -> dict[str, bytes]:
    about = (
        f"Metadata-Version: 2.1\nName: gnomon\nVersion: {_version()}\n"
        "Summary: Exact shadow geometry: umbra, penumbra and visible light\n"
        f"License: GPL-3.0-or-later\nRequires-Python: >=3.{sys.version_info.minor}\nRequires-Dist: numpy\n"
    )
    wheel = f"Wheel-Version: 1.0\nGenerator: gnomon\nRoot-Is-Purelib: false\nTag: {_tag()}\n"
    info = f"gnomon-{_version()}.dist-info"
    return {f"{info}/METADATA": about.encode(), f"{info}/WHEEL": wheel.encode()}


def _record_line(name: str, data: bytes) -> str:
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(data)}\n"


def build_wheel(wheel_directory: str, config_settings: Settings = None, metadata_directory: str | None = None) -> str:
    """Builds the wheel in that folder, and returns its name."""
    with tempfile.TemporaryDirectory() as prefix:
        _build(prefix)
        packages = pathlib.Path(prefix, PACKAGES)
        files = sorted(path for path in packages.rglob("*") if path.is_file())
        contents = {path.relative_to(packages).as_posix(): path.read_bytes() for path in files}
    contents |= _metadata()
    record = f"gnomon-{_version()}.dist-info/RECORD"
    lines = "".join(_record_line(name, data) for name, data in contents.items()) + f"{record},,\n"
    name = f"gnomon-{_version()}-{_tag()}.whl"
    with zipfile.ZipFile(pathlib.Path(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, data in {**contents, record: lines.encode()}.items():
            wheel.writestr(path, data)
    return name


def build_sdist(sdist_directory: str, config_settings: Settings = None) -> str:
    """There is none: the sources are those of the repository."""
    raise NotImplementedError("gnomon is built from its sources as they stand in the repository")
