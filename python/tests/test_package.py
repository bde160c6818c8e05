"""The whole package: version, imports, and the wheel that `pip install .` makes."""

import ast
import importlib.util
import os
import re
import subprocess
import sys
from pathlib import Path

import burnish
import pytest

SOURCE = Path(__file__).resolve().parents[2]


def output_of(*command, **environment):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, env=environment or None)
    assert done.returncode == 0, done.stdout
    return done.stdout.strip()


def test_version_matches_cmake():
    project = (SOURCE / "CMakeLists.txt").read_text()
    assert burnish.__version__ == re.search(r"project\(burnish VERSION ([0-9.]+)", project).group(1)


def test_imports_are_external_first_then_own_in_order():
    for file in sorted((SOURCE / "python/burnish").rglob("*.py")):
        statements = ast.parse(file.read_text()).body
        imports = [each for each in statements if isinstance(each, (ast.Import, ast.ImportFrom))]
        own = [(-each.level, each.module or "") for each in imports if getattr(each, "level", 0)]
        others = [each for each in imports if not getattr(each, "level", 0)]
        assert imports[:len(others)] == others, file
        assert own == sorted(own), file


def files_below(folder):
    return {path for path in folder.rglob("*") if "__pycache__" not in path.parts}


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """Wheel of this build, made in the same way as by `pip install .`."""
    build = Path(os.environ.get("BURNISH_BUILD_DIR", "/nowhere"))
    if not (build / "CMakeCache.txt").is_file():
        pytest.skip("BURNISH_BUILD_DIR names no build")
    settings = (build / "CMakeCache.txt").read_text()
    if re.search("^BUILD_SHARED_LIBS:[A-Z]+=(ON|TRUE|1)$", settings, re.MULTILINE):
        pytest.skip("wheels are made with static libraries")
    if not (build / "apps/burnish/burnish").is_file():
        pytest.skip("this build has no command line")
    spec = importlib.util.spec_from_file_location("burnish_build", SOURCE / "python/burnish_build.py")
    builder = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(builder)
    folder = tmp_path_factory.mktemp("wheel")
    return folder / builder.pack_wheel(build, folder)


def test_wheel_installs_library_command_line_and_robots(wheel, tmp_path):
    if importlib.util.find_spec("ensurepip") is None:
        pytest.skip("environments cannot be made: python3-venv is missing")
    place = tmp_path / "env"
    output_of(sys.executable, "-m", "venv", "--system-site-packages", place)
    before = files_below(place)
    pip = place / "bin/pip"
    output_of(pip, "install", "--no-index", "--no-deps", wheel)

    # The environment of this build does not reach the installed package.
    version = burnish.__version__
    program = place / "bin/burnish"
    assert output_of(program, "--version", PATH="/usr/bin:/bin") == f"burnish {version}"
    assert "talos" in output_of(program, "show", "talos", PATH="/usr/bin:/bin")
    script = f"""
import burnish, importlib.metadata
from burnish import polishing
from pathlib import Path
assert importlib.metadata.version("burnish") == burnish.__version__ == "{version}", burnish.__version__
place = Path("{place}").resolve()
for file in Path(burnish.__file__).resolve(), burnish.robot_search_path()[0].resolve():
    assert place in file.parents, file
task = polishing.make_task("table", polish_duration=0.2)
run = polishing.run_task(polishing.RunSpec(task=task, plant="ideal"))
assert "trace.csv" in run.write("{tmp_path}/run")
"""
    output_of(place / "bin/python", "-c", script, PATH="/usr/bin:/bin", PYTHONDONTWRITEBYTECODE="1")

    output_of(pip, "uninstall", "--yes", "burnish")
    left = files_below(place) - before
    assert not [path for path in left if path.is_file()], left
