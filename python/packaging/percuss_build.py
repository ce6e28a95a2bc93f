"""Builds the wheel of the Python module with CMake, for pip and other programs that follow PEP 517 and PEP 660.

Needs the standard library, CMake and the libraries of percuss, but no package from PyPI: `./start needs` lists the Debian
packages. The wheel runs in CPython 3.9 and later, since the module uses its stable interface only.
"""

from __future__ import annotations

import base64
import hashlib
import io
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
PRESET = "python"  # the preset of ./start python: both share one build
_EPOCH = (1980, 1, 1, 0, 0, 0)  # one date for all files, so that the same sources give the same wheel
_METADATA = """Metadata-Version: 2.1
Name: percuss
Version: {version}
Summary: Experimental modal analysis from impact tests
License: GPL-3.0-or-later
Requires-Python: >=3.9
Requires-Dist: numpy
Provides-Extra: plots
Requires-Dist: matplotlib; extra == "plots"
Provides-Extra: tables
Requires-Dist: pandas; extra == "tables"
Description-Content-Type: text/markdown

{readme}"""


def version() -> str:
    """The version in CMakeLists.txt."""
    return re.search(r"project\(percuss VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text(encoding="utf-8"))[1]


def tag() -> str:
    return f"cp39-abi3-{re.sub(r'[-.]', '_', sysconfig.get_platform())}"


def _run(*words: str) -> None:
    try:
        ran = subprocess.run(words, cwd=SOURCE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", check=False)
    except FileNotFoundError:
        raise SystemExit(f"percuss: no {words[0]}; install the packages that `./start needs` prints") from None
    if ran.returncode != 0:
        sys.stderr.write(ran.stdout[-8000:])
        raise SystemExit(f"percuss: {words[0]} failed (see above); a library may be missing: install the packages that `./start needs` prints")


def compile_module() -> None:
    jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or str(os.cpu_count() or 1)
    _run("cmake", "--preset", PRESET, f"-DPython3_EXECUTABLE={sys.executable}")
    _run("cmake", "--build", "--preset", PRESET, "--parallel", jobs, "--target", "percuss_python")


def _installed_files() -> dict[str, bytes]:
    """The package as CMake installs it, stripped, by path within the wheel."""
    with tempfile.TemporaryDirectory() as prefix:
        _run("cmake", "--install", f"build/{PRESET}", "--component", "python", "--strip", "--prefix", prefix)
        [package] = pathlib.Path(prefix).rglob("percuss/__init__.py")
        top = package.parent.parent
        return {str(one.relative_to(top)): one.read_bytes() for one in sorted(top.rglob("*")) if one.is_file()}


def _information() -> dict[str, bytes]:
    folder = f"percuss-{version()}.dist-info"
    readme = (SOURCE / "docs" / "tutorials" / "python.md").read_text(encoding="utf-8")
    return {
        f"{folder}/METADATA": _METADATA.format(version=version(), readme=readme).encode(),
        f"{folder}/WHEEL": f"Wheel-Version: 1.0\nGenerator: percuss_build\nRoot-Is-Purelib: false\nTag: {tag()}\n".encode(),
        f"{folder}/LICENSE": (SOURCE / "LICENSE").read_bytes(),
    }


def _write_wheel(folder: str, files: dict[str, bytes]) -> str:
    name = f"percuss-{version()}-{tag()}.whl"
    record = f"percuss-{version()}.dist-info/RECORD"
    lines = []
    for path, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        lines.append(f"{path},sha256={digest},{len(content)}\n")
    files = {**files, record: ("".join(lines) + f"{record},,\n").encode()}
    with zipfile.ZipFile(os.path.join(folder, name), "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in files.items():
            entry = zipfile.ZipInfo(path, _EPOCH)
            entry.external_attr = (0o755 if path.endswith(".so") else 0o644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            wheel.writestr(entry, content)
    return name


# The hooks of PEP 517 and PEP 660. Settings are not used.


def get_requires_for_build_wheel(config_settings: object = None) -> list[str]:
    return []


def build_wheel(wheel_directory: str, config_settings: object = None, metadata_directory: str | None = None) -> str:
    compile_module()
    return _write_wheel(wheel_directory, {**_installed_files(), **_information()})


def prepare_metadata_for_build_wheel(metadata_directory: str, config_settings: object = None) -> str:
    for path, content in _information().items():
        target = pathlib.Path(metadata_directory) / path
        target.parent.mkdir(exist_ok=True)
        target.write_bytes(content)
    return f"percuss-{version()}.dist-info"


def build_editable(wheel_directory: str, config_settings: object = None, metadata_directory: str | None = None) -> str:
    """A wheel that points to the build folder, whose Python files are links to the sources."""
    compile_module()
    return _write_wheel(wheel_directory, {"percuss.pth": f"{SOURCE / 'build' / PRESET / 'python'}\n".encode(), **_information()})


def build_sdist(sdist_directory: str, config_settings: object = None) -> str:
    """The files that git tracks."""
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=SOURCE, stdout=subprocess.PIPE, check=True).stdout
    top = f"percuss-{version()}"
    information = _METADATA.format(version=version(), readme="").encode()
    with tarfile.open(os.path.join(sdist_directory, f"{top}.tar.gz"), "w:gz", format=tarfile.PAX_FORMAT) as archive:
        for name in filter(None, listed.decode().split("\0")):
            archive.add(SOURCE / name, f"{top}/{name}", recursive=False)
        entry = tarfile.TarInfo(f"{top}/PKG-INFO")
        entry.size = len(information)
        archive.addfile(entry, io.BytesIO(information))
    return f"{top}.tar.gz"
