"""Builds the Python package for `pip install .`: CMake builds and installs it into a folder, which
then becomes a wheel. Needs nothing but the standard library, so that no network is needed either.

CMAKE_ARGS in the environment, or `--config-settings cmake-args=...`, go to CMake; JOBS is the number
of compilers at a time. The build folder build-wheel is kept, so that a second time is fast; where it
was made in another way, or fails, everything starts anew."""

import base64
import hashlib
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import zipfile
from pathlib import Path

SOURCE = Path(__file__).resolve().parent.parent
OFF = ("TESTS", "APPS", "EXAMPLES", "BENCHMARKS", "PAGE", "MESHES")


def _version():
    found = re.search(r"project\(burnish VERSION ([0-9.]+)", (SOURCE / "CMakeLists.txt").read_text())
    if not found:
        sys.exit("burnish_build: no version in CMakeLists.txt")
    return found.group(1)


def _metadata():
    return (
        "Metadata-Version: 2.1\n"
        "Name: burnish\n"
        f"Version: {_version()}\n"
        "Summary: Contact dynamics, its derivatives in any reference frame, and optimal control\n"
        "License: BSD-3-Clause\n"
        "Requires-Python: >=3.9\n"
        "Requires-Dist: numpy>=1.21\n"
        "Provides-Extra: plot\n"
        "Requires-Dist: matplotlib; extra == 'plot'\n"
    )


def _tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    return f"{python}-{python}-{platform}"


class _Failed(Exception):
    pass


def _run(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        raise _Failed(f"'{shlex.join(command[:3])} ...' failed:\n{done.stdout[-8000:]}")
    return done.stdout


def _cmake_arguments(settings):
    given = (settings or {}).get("cmake-args", "")
    extra = shlex.split(os.environ.get("CMAKE_ARGS", ""))
    return extra + [word for text in ([given] if isinstance(given, str) else given) for word in shlex.split(text)]


def _ways(extra):
    """What CMake remembers of its first call in a folder, and would not notice a change of."""
    names = sorted(name for name in os.environ if name.startswith("CMAKE_"))
    return {"arguments": extra, "python": [os.path.realpath(sys.executable), sys.version],
            "environment": {name: os.environ.get(name) for name in ["CC", "CXX", "CXXFLAGS", "LDFLAGS", *names]}}


def _configure_and_build(build, extra):
    said = _run(
        "cmake", "-S", str(SOURCE), "-B", str(build), "-DCMAKE_BUILD_TYPE=Release",
        "-DBURNISH_PYTHON=ON", "-DBURNISH_PYTHON_INSTALL_DIR=.", f"-DPython3_EXECUTABLE={sys.executable}",
        *(f"-DBURNISH_{part}=OFF" for part in OFF), *extra,
    )
    parts = [line for line in said.splitlines() if "burnish:" in line]
    if not any("Python: on" in line for line in parts):
        raise _Failed("something that the package needs is missing (scripts/setup installs it on Debian):\n"
                      + "\n".join(parts))
    _run("cmake", "--build", str(build), "--target", "burnish_python",
         "-j", os.environ.get("JOBS", str(os.cpu_count() or 1)))


def _build(stage, settings):
    build = SOURCE / "build-wheel"
    extra = _cmake_arguments(settings)
    ways, record = json.dumps(_ways(extra)), build / "burnish_build.json"
    if not record.exists() or record.read_text() != ways:
        shutil.rmtree(build, ignore_errors=True)
    kept = build.exists()
    build.mkdir(exist_ok=True)
    record.write_text(ways)
    try:
        try:
            _configure_and_build(build, extra)
        except _Failed:
            # What an interrupted call left, or what was moved or upgraded since, may be the reason.
            if not kept:
                raise
            print(f"burnish_build: {build} of an earlier call is of no use, starting anew", flush=True)
            shutil.rmtree(build)
            build.mkdir()
            record.write_text(ways)
            _configure_and_build(build, extra)
        for component in ("python", "python_data"):
            _run("cmake", "--install", str(build), "--component", component, "--prefix", str(stage))
    except _Failed as failure:
        sys.exit(f"burnish_build: {failure}")


def get_requires_for_build_wheel(config_settings=None):
    return []


def _write_info(folder):
    folder.mkdir()
    (folder / "METADATA").write_text(_metadata())
    (folder / "WHEEL").write_text(
        f"Wheel-Version: 1.0\nGenerator: burnish\nRoot-Is-Purelib: false\nTag: {_tag()}\n")


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    name = f"burnish-{_version()}.dist-info"
    _write_info(Path(metadata_directory) / name)
    return name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    name = f"burnish-{_version()}-{_tag()}.whl"
    info = f"burnish-{_version()}.dist-info"
    with tempfile.TemporaryDirectory() as folder:
        stage = Path(folder)
        _build(stage, config_settings)
        _write_info(stage / info)
        (stage / info / "LICENSE").write_text((SOURCE / "LICENSE").read_text())
        files = sorted(p for p in stage.rglob("*") if p.is_file())
        lines = []
        with zipfile.ZipFile(Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
            for file in files:
                data = file.read_bytes()
                place = file.relative_to(stage).as_posix()
                digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
                lines.append(f"{place},sha256={digest},{len(data)}")
                wheel.writestr(place, data)
            lines.append(f"{info}/RECORD,,")
            wheel.writestr(f"{info}/RECORD", "\n".join(lines) + "\n")
    return name


def build_sdist(sdist_directory, config_settings=None):
    sys.exit("burnish_build: there are no source archives; install from the repository")
