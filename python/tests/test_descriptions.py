"""Committed files that are generated from the descriptions of specifications are up to date."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from burnish import _core

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "scripts" / "describe"


@pytest.mark.skipif(not SCRIPT.exists(), reason="a package without its sources")
def test_committed_headers_and_docs_match_the_descriptions() -> None:
    done = subprocess.run([sys.executable, str(SCRIPT), "--core", str(_core.__file__)],
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def test_every_entry_has_a_meaning() -> None:
    for spec in _core.descriptions():
        assert spec["meaning"], spec["name"]
        # Keys of different sections of a task file may have the same name, but entries may not.
        names = [field["name"] for field in spec["fields"]]
        assert len(set(names)) == len(names), spec["name"]
        for field in spec["fields"]:
            assert not field["unit"] or field["unit"] in field["comment"]


def test_number_too_large_for_its_entry_raises() -> None:
    from burnish import Disturbances, Error
    with pytest.raises(Error, match="Disturbances.encoder_bits: got 4294967297; wanted a whole"):
        _core.spec_round_trip(Disturbances(encoder_bits=2**32 + 1))
    assert _core.spec_round_trip(Disturbances(seed=2**64 - 1)).seed == 2**64 - 1


@pytest.mark.skipif(not SCRIPT.exists(), reason="a package without its sources")
def test_build_writes_every_described_class_into_its_module(tmp_path: Path) -> None:
    (tmp_path / "base.py").symlink_to(SCRIPT)  # the link must be replaced, not written through
    before = SCRIPT.read_text()
    subprocess.run([sys.executable, str(SCRIPT), "--core", str(_core.__file__), "--package", str(tmp_path)], check=True)
    assert SCRIPT.read_text() == before
    package = Path(_core.__file__).parent
    written = {str(path.relative_to(tmp_path)) for path in tmp_path.rglob("*") if path.is_file()}
    assert {"__init__.py", "_core.pyi", "py.typed", "campaign/__init__.py"} < written
    for name in written:
        assert (tmp_path / name).read_text() == (package / name).read_text(), name
    for spec in _core.descriptions() + _core.enumerations():
        assert (tmp_path / f"{spec['module']}.py").read_text().count(f"\nclass {spec['name']}(") == 1, spec["name"]


@pytest.mark.skipif(not SCRIPT.exists(), reason="a package without its sources")
def test_table_of_problem_keys_matches_sources_and_headers() -> None:
    """Sources read every key of the table, and headers declare every member."""
    docs = (ROOT / "docs/files.md").read_text()
    table = re.search(r"<!-- names of problem files -->\n(.*?)<!-- end -->", docs, re.DOTALL)
    assert table
    sources = "".join(path.read_text() for path in (ROOT / "src/files").glob("*.cpp"))
    headers = "".join(path.read_text() for path in (ROOT / "include/burnish").rglob("*.hpp"))
    rows = [row.split("|")[1:3] for row in table[1].splitlines()[2:]]
    assert len(rows) > 5
    for keys, members in rows:
        for key in re.findall(r"`([\w.]+)", keys):
            assert f'"{key.split(".")[-1]}"' in sources or key.endswith("NAME"), key
        for owner, member in re.findall(r"`(\w+)\.(\w+)", members):
            if owner != "residual":
                assert re.search(rf"struct {owner} (final )?{{.*?\b{member}\b.*?\n}};", headers, re.DOTALL), member
