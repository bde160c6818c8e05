"""Data sets: consistent contents, records that read back unchanged and replay to the bit."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import burnish
from burnish import dataset, polishing

h5py = pytest.importorskip("h5py", reason="h5py is not installed (python3-h5py)")

PROBLEMS = Path(__file__).resolve().parents[2] / "examples" / "problems"


def short_task(seed):
    return polishing.make_task("table", seed=seed, polish_duration=0.2, update_rate=200.0,
                               overrides=["path.start_up=0.1", "path.radius=0.02"])


def expect_same(a, b):
    assert (a.kind, a.text, a.names, a.attributes) == (b.kind, b.text, b.names, b.attributes)
    assert list(a.arrays) == list(b.arrays) or sorted(a.arrays) == sorted(b.arrays)
    for name, array in a.arrays.items():
        assert array.dtype == b.arrays[name].dtype and array.shape == b.arrays[name].shape, name
        assert array.tobytes() == b.arrays[name].tobytes(), name


@pytest.fixture(scope="module")
def solutions(tmp_path_factory):
    file = tmp_path_factory.mktemp("data") / "solutions.h5"
    problem = burnish.Problem(burnish.read_problem_file(PROBLEMS / "reaching.yaml").spec)
    states = [problem.initial_state, problem.initial_state + 1e-3]
    return file, dataset.write_solutions(file, PROBLEMS / "reaching.yaml", states)


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    file = tmp_path_factory.mktemp("data") / "runs.h5"
    return file, dataset.write_runs(file, [short_task(seed) for seed in (1, 2)], plant="ideal")


def test_solution_has_gains_values_and_the_contact_schedule():
    record = dataset.make_solution(PROBLEMS / "trotting.yaml")
    a, knots = record.arrays, len(record.arrays["time"]) - 1
    file = burnish.read_problem_file(PROBLEMS / "trotting.yaml")
    problem = burnish.Problem(file.spec)
    assert knots == problem.knots
    assert a["x"].shape == (knots + 1, problem.nx) and len(record.names["x"]) >= problem.ndx
    assert a["u"].shape == (knots, problem.max_controls) and len(record.names["u"]) == problem.max_controls
    assert a["K"].shape == (knots, problem.max_controls, problem.ndx)
    assert a["Vx"].shape == (knots + 1, problem.ndx) and a["Vxx"].shape == (knots + 1, problem.ndx, problem.ndx)
    assert np.allclose(a["Vxx"], np.swapaxes(a["Vxx"], 1, 2))
    assert (np.diff(a["time"]) >= 0).all()
    # Feet alternate; a force is finite exactly while its contact is active.
    assert a["contact"].shape == (knots, len(record.names["contact"])) and not a["contact"].all()
    for k in range(knots):
        active = {name for name, on in zip(record.names["contact"], a["contact"][k]) if on}
        with_force = {name.split("/")[0] for name, f in zip(record.names["force"], a["force"][k]) if np.isfinite(f)}
        impact = next(stage.impact for stage in problem.spec.stages
                      if stage.name == problem.stage_names[problem.stage_of(k)])
        assert with_force == (set() if impact else active)
        controls = problem.controls(k)
        assert np.isfinite(a["u"][k, :controls]).all() and np.isnan(a["u"][k, controls:]).all()


def test_run_has_all_signals_and_their_parts(runs):
    record = runs[1][0]
    a = record.arrays
    assert a["signals"].shape == (len(a["time"]), len(record.names["signals"]))
    assert "solve_time" not in record.names["signals"] and len(record.names["units"]) == a["signals"].shape[1]
    for part in ("q", "v", "tau", "force", "target"):
        assert a[part].shape == (len(a["time"]), len(record.names[part])) and len(record.names[part]) >= 3, part
    assert a["contact"].any() and not a["contact"].all()
    assert a["plan_q"].shape[0] == len(a["plan_time"]) > 0


def test_plans_of_a_run_have_gains_and_values_at_their_start(runs):
    a = runs[1][0].arrays
    plans, nx, nu = len(a["plan_time"]), a["plan_x"].shape[1], a["plan_u"].shape[1]
    assert (nx, nu) == (2 * nu, a["q"].shape[1])
    assert a["plan_K"].shape == (plans, nu, nx) and a["plan_Vxx"].shape == (plans, nx, nx)
    assert a["plan_Vx"].shape == (plans, nx)
    assert np.allclose(a["plan_x"][:, :nu], a["plan_q"][:, 0], atol=1e-6)  # stored in single precision
    assert all(np.isfinite(a[f"plan_{name}"]).all() for name in ("x", "u", "K", "Vx", "Vxx"))
    for Vxx in a["plan_Vxx"]:
        assert np.allclose(Vxx, Vxx.T) and np.linalg.eigvalsh(Vxx)[0] > 0
    # The option plan_rate sets how often plans are recorded.
    more = dataset.make_run(short_task(1), plant="ideal", plan_rate=100.0)
    assert len(more.arrays["plan_time"]) > 3 * plans
    assert np.array_equal(more.arrays["signals"], a["signals"])


@pytest.mark.parametrize("kind", ["solutions", "runs"])
def test_records_read_back_and_replay_to_the_bit(kind, request):
    file, records = request.getfixturevalue(kind)
    loaded = dataset.load(file)
    assert len(loaded) == len(records) == 2
    for record, read in zip(records, loaded):
        expect_same(record, read)
        expect_same(read, dataset.replay(read))
    first, second = loaded
    main = "x" if kind == "solutions" else "signals"
    assert first.arrays[main].tobytes() != second.arrays[main].tobytes()


def test_record_replays_without_its_file(solutions, tmp_path):
    record = dataset.load(solutions[0])[0]
    record.attributes["file"] = str(tmp_path / "gone.yaml")
    expect_same(record, dataset.replay(record))


def test_invalid_data_set_raises(tmp_path):
    (tmp_path / "text.h5").write_text("no")
    with pytest.raises(burnish.Error, match="cannot read the data set"):
        dataset.load(tmp_path / "text.h5")
    with h5py.File(tmp_path / "other.h5", "w"):
        pass
    with pytest.raises(burnish.Error, match="is not a data set of burnish; wanted the format 'burnish dataset 1'"):
        dataset.load(tmp_path / "other.h5")
    with pytest.raises(burnish.Error, match="cannot write"):
        dataset.write(tmp_path / "nowhere" / "a.h5", [])
    with pytest.raises(burnish.Error):
        dataset.make_solution(tmp_path / "nowhere.yaml")
