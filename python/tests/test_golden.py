"""scripts/golden: columns read from a run, and the distinction of equal, rounding and different."""

from __future__ import annotations

import json
import math
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

SCRIPTS = Path(__file__).resolve().parents[2] / "scripts"
if not SCRIPTS.exists():
    pytest.skip("a package without its sources", allow_module_level=True)
sys.path.insert(0, str(SCRIPTS))

import golden_columns as golden
import golden_runs

UP = 1 + 2.0**-52


def trace(folder: Path, rows: list[tuple[float, ...]], header: str) -> Path:
    file = folder / "trace.csv"
    file.write_text("\n".join([header, *(",".join(map(repr, row)) for row in rows)]) + "\n")
    return file


def columns(**lists: list[float]) -> dict[str, list[str]]:
    """Returns columns of text; the first letter of a name selects the unit (q, t, n)."""
    unit = {"q": "rad", "t": "Nm", "n": "-"}
    return {f"{name} [{unit[name[0]]}]": [repr(value) for value in values] for name, values in lists.items()}


def test_difference_of_one_unit_in_the_last_place_is_found(tmp_path: Path) -> None:
    header = "time [s],q_knee [rad],solve_time [s]"
    theirs = golden.columns_of(trace(tmp_path, [(0.0, 1.0, 0.1), (0.1, 1.0, 0.2)], header), {})
    ours = golden.columns_of(trace(tmp_path, [(0.0, 1.0, 0.3), (0.1, UP, 0.4)], header), {})
    found = golden.first_difference(theirs, ours)
    assert found is not None and found.row == 1
    assert str(found) == "q_knee [rad]: 1.0000000000000002, PARENT has 1.0, 2.2e-16 off"
    assert golden.first_difference(theirs, theirs) is None


def test_zeros_of_different_sign_differ() -> None:
    found = golden.first_difference(columns(q=[0.0]), columns(q=[-0.0]))
    assert found is not None and golden.distance(found.theirs, found.ours) == 0


def test_different_number_of_rows_is_a_difference(tmp_path: Path) -> None:
    theirs = golden.columns_of(trace(tmp_path, [(1.0,), (2.0,)], "q [rad]"), {})
    ours = golden.columns_of(trace(tmp_path, [(1.0,)], "q [rad]"), {})
    found = golden.first_difference(theirs, ours)
    assert found is not None and (found.column, found.theirs, found.ours) == ("rows", "2", "1")
    assert golden.beyond_rounding(theirs, ours, [theirs]).column == "rows"


def test_renamed_columns_are_compared_and_missing_ones_reported(tmp_path: Path) -> None:
    names = {"bend": "curvature", "believed_*": "estimated_*"}
    theirs = golden.columns_of(trace(tmp_path, [(1.0, 2.0)], "bend [1/m],believed_x [m]"), names)
    ours = golden.columns_of(trace(tmp_path, [(1.0, 2.0, 3.0)], "curvature [1/m],estimated_x [m],new [-]"), {})
    assert golden.first_difference(theirs, ours) is None  # a new column is not a difference
    del ours["estimated_x [m]"]
    found = golden.first_difference(theirs, ours)
    assert str(found) == "estimated_x [m]: no such column, PARENT has 2.0"
    assert golden.beyond_rounding(theirs, ours, [theirs]) == found


def test_json_is_compared_by_path_without_measured_times(tmp_path: Path) -> None:
    def read(**more: object) -> dict[str, list[str]]:
        content = {"outcome": "polished: 4.2 s, simulated in 7.8 s", "ticks": {"mean_s": 0.1, "count": 3}} | more
        (tmp_path / "metrics.json").write_text(json.dumps(content))
        found: dict[str, list[str]] = golden.columns_of(tmp_path / "metrics.json", {})
        return found
    theirs = read(gains=[[1.0, 2.0]])
    assert theirs == read(gains=[[1.0, 2.0]], outcome="polished: 4.2 s, simulated in 61.3 s",
                          ticks={"mean_s": 0.2, "count": 3})
    found = golden.first_difference(theirs, read(gains=[[1.0, 2.5]]))
    assert found is not None and found.column == "gains[0][1]"


def test_rounding_limit_is_ten_times_a_nudge_in_the_same_unit() -> None:
    theirs = columns(t1=[1.0, 1.0], t2=[2.0, 2.0], q=[1.0, 1.0])
    nudged = columns(t1=[1.0 + 1e-12, 1.0], t2=[2.0, 2.0], q=[1.0, UP])
    assert golden.beyond_rounding(theirs, theirs | columns(t2=[2.0, 2.0 + 9e-12]), [nudged]) is None
    found = golden.beyond_rounding(theirs, theirs | columns(t2=[2.0, 2.0 + 11e-12]), [nudged])
    assert found is not None and (found.row, found.column) == (1, "t2 [Nm]")
    assert math.isclose(found.explained, 1e-11, rel_tol=1e-3)
    assert golden.beyond_rounding(theirs, theirs | columns(q=[1.0 + 1e-12, 1.0]), [nudged]) is not None


def test_rounding_limit_grows_along_a_run() -> None:
    rows = 3 * golden.AHEAD
    theirs = columns(q=[1.0] * rows)
    nudged = columns(q=[1.0 + 1e-15 * 2.0**row for row in range(rows)])
    def is_beyond(row: int, by: float) -> bool:
        ours = columns(q=[1.0 + by * (row == at) for at in range(rows)])
        return golden.beyond_rounding(theirs, ours, [nudged]) is not None
    last = 1e-15 * 2.0 ** (rows - 1)
    assert is_beyond(0, last) and not is_beyond(rows - 1, last)
    ahead = 1e-15 * 2.0**golden.AHEAD  # size of the difference AHEAD rows earlier
    assert not is_beyond(0, 9 * ahead) and is_beyond(0, 11 * ahead)


def test_integer_columns_have_no_rounding_limit() -> None:
    theirs, nudged = columns(n1=[3, 3], n2=[0.5, 0.5]), columns(n1=[3, 3], n2=[0.5, 1.5])
    assert golden.beyond_rounding(theirs, theirs | columns(n2=[0.5, 2.5]), [nudged]) is None
    found = golden.beyond_rounding(theirs, theirs | columns(n1=[4, 3]), [nudged])
    assert found is not None and found.column == "n1 [-]"


def test_figures_have_a_relative_rounding_limit() -> None:
    theirs = {"friction_used": ["0.5"], "done": ["true"]}
    assert golden.beyond_rounding(theirs, theirs | {"friction_used": [repr(0.5 + 4e-8)]}, [theirs]) is None
    assert golden.beyond_rounding(theirs, theirs | {"friction_used": [repr(0.5 + 6e-8)]}, [theirs]) is not None
    assert golden.beyond_rounding(theirs, theirs | {"done": ["false"]}, [theirs]) is not None


def test_different_words_differ_and_numbers_in_sentences_do_not() -> None:
    assert golden.distance("cost 0.25, 1e-10 to go", "cost 0.26, 2.5 to go") == 0
    assert golden.distance("cost 0.25", "stuck at 0.25") == math.inf
    assert golden.distance("true", "false") == math.inf
    assert not golden.distance("nan", "1.0") <= 1e300


def test_nudge_changes_the_joints_of_postures_only() -> None:
    text = ("mass: 1.5\npostures:  # of 2 joints\n  bent:\n    root: [0, 0, 1.5]\n    knee: 1.0  # rad\n"
            "  flat: {knee: 0, hip: -0.5}\nframes: {tip: 0.25}\n")
    flat = f"{{knee: {2.0**-52!r}, hip: {-0.5 * (1 - 2.0**-53)!r}}}"
    wanted = text.replace("knee: 1.0", f"knee: {UP!r}").replace("{knee: 0, hip: -0.5}", flat)
    assert golden.nudge(text, "postures", math.inf) == wanted
    assert golden.nudge(text, "start", math.inf) == text


@pytest.mark.skipif(shutil.which("git") is None, reason="no git")
@pytest.mark.parametrize("words, message", [
    (["no-such-commit"], "'no-such-commit' is not a commit"),
    (["HEAD", "--build", "no-such-build"], "is not a configured build folder"),
])
def test_invalid_arguments_exit_with_the_reason(words: list[str], message: str, tmp_path: Path) -> None:
    (tmp_path / "CMakeCache.txt").write_text("")
    done = subprocess.run([str(SCRIPTS / "golden"), "--build", str(tmp_path), *words], capture_output=True, text=True)
    assert done.returncode == 2 and message in done.stderr


def test_every_named_surface_is_run() -> None:
    from burnish import polishing

    assert set(golden_runs.SURFACES) == {surface.name for surface in polishing.named_surfaces()}


def test_sentences_are_compared_by_numbers_and_words_by_new_names(tmp_path: Path) -> None:
    theirs, ours = tmp_path / "theirs.json", tmp_path / "ours.json"
    theirs.write_text('{"phase": "lean", "why": "the force came to 1.5 N at most"}')
    ours.write_text('{"phase": "force_search", "why": "the largest force was 1.5 N"}')
    names = {"lean": "force_search"}
    assert golden.columns_of(theirs, names) == golden.columns_of(ours, {})
    ours.write_text('{"phase": "force_search", "why": "the largest force was 1.6 N"}')
    assert golden.columns_of(theirs, names) != golden.columns_of(ours, {})
