"""Builds the Python package and the command line for `pip install .`: CMake builds and installs them
into a folder, which then becomes a wheel. Needs nothing but the standard library.

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
OFF = ("TESTS", "EXAMPLES", "BENCHMARKS")
NEEDED = ("Python", "command line")
COMPONENTS = ("python", "program", "documents")


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
        "-DBURNISH_PYTHON=AUTO", "-DBURNISH_PYTHON_INSTALL_DIR=.", f"-DPython3_EXECUTABLE={sys.executable}",
        *(f"-DBURNISH_{part}=OFF" for part in OFF), *extra,
    )
    parts = [line for line in said.splitlines() if "burnish:" in line]
    if not all(any(f"{part}: on" in line for line in parts) for part in NEEDED):
        raise _Failed("something that the package needs is missing (scripts/setup installs it on Debian):\n"
                      + "\n".join(parts))
    _run("cmake", "--build", str(build), "-j", os.environ.get("JOBS", str(os.cpu_count() or 1)))


def _build(settings):
    build = SOURCE / "build-wheel"
    extra = _cmake_arguments(settings)
    ways, record = json.dumps(_ways(extra)), build / "burnish_build.json"
    if not record.exists() or record.read_text() != ways:
        shutil.rmtree(build, ignore_errors=True)
    kept = build.exists()
    build.mkdir(exist_ok=True)
    record.write_text(ways)
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
    return build


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


def _cached(build, name):
    found = re.search(rf"^{name}:\w+=(.*)$", (build / "CMakeCache.txt").read_text(), re.MULTILINE)
    if not found:
        raise _Failed(f"{build} was not configured with {name}")
    return found.group(1)


def _contents(build, stage):
    """What a wheel of this build holds: (place in the wheel, file) of each. The program, robots and
    tasks go where the environment has its own programs and shared files."""
    for component in COMPONENTS:
        _run("cmake", "--install", str(build), "--component", component, "--prefix", str(stage), "--strip")
    data = f"burnish-{_version()}.data"
    package = stage / _cached(build, "BURNISH_PYTHON_INSTALL_DIR")
    for folder, place in ((package / "burnish", "burnish"), (stage / "bin", f"{data}/scripts"),
                          (stage / "share", f"{data}/data/share")):
        for file in sorted(p for p in folder.rglob("*") if p.is_file()):
            yield f"{place}/{file.relative_to(folder).as_posix()}", file


def pack_wheel(build, wheel_directory):
    """Makes a wheel of what was built in this folder, and returns its name."""
    name = f"burnish-{_version()}-{_tag()}.whl"
    info = f"burnish-{_version()}.dist-info"
    with tempfile.TemporaryDirectory() as folder:
        stage, about = Path(folder) / "stage", Path(folder) / info
        files = list(_contents(build, stage))
        _write_info(about)
        (about / "LICENSE").write_text((SOURCE / "LICENSE").read_text())
        files += [(f"{info}/{file.name}", file) for file in sorted(about.iterdir())]
        lines = []
        with zipfile.ZipFile(Path(wheel_directory) / name, "w") as wheel:
            def write(place, data, mode):
                entry = zipfile.ZipInfo(place)  # of a fixed date
                entry.compress_type = zipfile.ZIP_DEFLATED
                entry.external_attr = mode << 16  # programs stay programs
                wheel.writestr(entry, data)

            for place, file in files:
                data = file.read_bytes()
                digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
                lines.append(f"{place},sha256={digest},{len(data)}")
                write(place, data, file.stat().st_mode)
            lines.append(f"{info}/RECORD,,")
            write(f"{info}/RECORD", "\n".join(lines) + "\n", 0o100644)
    return name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    try:
        return pack_wheel(_build(config_settings), wheel_directory)
    except _Failed as failure:
        sys.exit(f"burnish_build: {failure}")


def build_sdist(sdist_directory, config_settings=None):
    sys.exit("burnish_build: there are no source archives; install from the repository")
