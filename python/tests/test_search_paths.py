"""Programs and modules in the working folder, which may be untrusted, are not executed."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from burnish import campaign
from burnish.campaign._dask import find_program
from test_campaign import _has_program

pytestmark = pytest.mark.skipif(not _has_program(), reason="the program burnish is not built")

MODULES = ("burnish", "burnish/campaign", "numpy", "distributed", "json", "runpy", "sitecustomize", "usercustomize")
PROGRAMS = ("python3", "burnish", "timeout")


@pytest.fixture()
def planted(tmp_path, monkeypatch):
    """Working folder whose modules and programs write a mark when executed."""
    folder = tmp_path / "stranger"
    mark = tmp_path / "executed"
    for module in MODULES:
        (folder / module).mkdir(parents=True)
        (folder / module / "__init__.py").write_text(f"open({str(mark)!r}, 'a').write({module!r} + ' ')\n")
    for program in PROGRAMS:
        # In a folder of its own, because the package of that name is a folder.
        place = folder / "bin" / program
        place.parent.mkdir(exist_ok=True)
        place.write_text(f"#!/bin/sh\nprintf '%s ' {program} >> {mark}\n")
        place.chmod(0o755)
    (folder / "sweep.yaml").write_text("task: {task: polishing}\n")
    monkeypatch.chdir(folder)
    return mark


def run_program(words, **variables):
    environment = {**os.environ, **{name: value for name, value in variables.items() if value is not None}}
    for name, value in variables.items():
        if value is None:
            environment.pop(name, None)
    return subprocess.run([campaign.program(), *words], capture_output=True, text=True, env=environment)


PATH = os.environ.get("PATH", os.defpath)


@pytest.mark.parametrize("words", [["sweep", "sweep.yaml"], ["tune", "sweep.yaml"],
                                   ["experiment", "seeds", "--seeds", "1", "--scheduler", "tcp://127.0.0.1:1"]])
@pytest.mark.parametrize("modules", [None, "", ":", "."])
def test_working_folder_is_not_searched(planted, words, modules):
    done = run_program(words, PYTHONPATH=modules, PATH=f"bin:{PATH}:")
    assert not planted.exists(), planted.read_text()
    assert done.returncode == 2
    assert done.stderr.startswith("burnish: ") and done.stderr.count("\n") == 1
    if words[0] != "experiment":  # the installed package was found, executed, and refused the file
        assert "does not find" not in done.stderr


def test_absolute_folder_in_pythonpath_is_searched(planted):
    run_program(["sweep", "sweep.yaml"], PYTHONPATH=os.getcwd())
    assert "sitecustomize" in planted.read_text()


def test_child_processes_of_python_do_not_search_the_working_folder(planted, tmp_path):
    recorder = tmp_path / "own"
    recorder.mkdir()
    (recorder / "sitecustomize.py").write_text(
        "import os\nfor name in ('PATH', 'PYTHONPATH', 'PYTHONSAFEPATH'):\n"
        f"    open({str(tmp_path / 'variables')!r}, 'a').write(os.environ[name] + '\\n')\n")
    run_program(["sweep", "sweep.yaml"], PYTHONPATH=f"{recorder}::.", PATH=f"bin:.:{PATH}::")
    programs, modules, safe = (tmp_path / "variables").read_text().splitlines()[:3]
    assert all(os.path.isabs(entry) for entry in (programs + ":" + modules).split(":"))
    assert safe == "1"


def test_programs_are_found_in_absolute_folders_only(planted, monkeypatch):
    own = Path("bin").resolve()
    for path, wanted in ((f"bin:.::{own}", str(own / "burnish")), ("bin:.:", None), ("", None)):
        monkeypatch.setenv("PATH", path)
        assert find_program("burnish") == wanted


def test_python_without_its_own_path_takes_no_program_here(planted, monkeypatch):
    monkeypatch.chdir("bin")
    monkeypatch.setattr(sys, "executable", "")
    monkeypatch.delenv("BURNISH_PROGRAM", raising=False)
    assert os.path.isabs(campaign.program())
    monkeypatch.setattr(campaign, "__file__", os.path.join(os.getcwd(), "burnish", "campaign", "__init__.py"))
    monkeypatch.setenv("PATH", ":.")
    with pytest.raises(campaign.CampaignError, match="was not found"):
        campaign.program()


def test_package_beside_a_folder_apps_is_not_a_build(planted, monkeypatch):
    place = Path("apps/burnish/burnish").resolve()
    place.parent.mkdir(parents=True)
    place.write_text("#!/bin/sh\n")
    place.chmod(0o755)
    monkeypatch.setattr(campaign, "__file__", str(Path("lib/burnish/campaign/__init__.py").resolve()))
    monkeypatch.setattr(sys, "executable", "")
    monkeypatch.delenv("BURNISH_PROGRAM", raising=False)
    monkeypatch.setenv("PATH", "")
    with pytest.raises(campaign.CampaignError, match="was not found"):
        campaign.program()
