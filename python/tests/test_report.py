"""Measures of runs and plots."""

from __future__ import annotations

import ast
import inspect
import math
import pathlib
import pickle

import numpy as np
import pytest

import burnish
from burnish import polishing, press_hold, push_wall, report, stand

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs"


@pytest.fixture(scope="module")
def robot():
    return burnish.load_robot("arm7")


@pytest.fixture(scope="module")
def run(robot):
    """Returns the loop and the normal of a baseline run along a circle, with friction and noise."""
    q = robot.posture("ready")
    tip = burnish.with_surface_at(robot.model, q, [0.1, -0.2, 1.0],
                                  burnish.TouchSpec("tool"), clearance=0.004)
    nominal = burnish.SceneSpec([tip])
    disturbances = burnish.Disturbances(seed=3, force_noise=0.2, surface_friction=0.2,
                                        mass_scale=1.05)
    n = tip.surface.normal
    path = burnish.CirclePath(tip.surface.point + tip.radius * n, n, radius=0.02,
                              rate=4.0, start_up=0.5, force=15.0)
    controller = burnish.make_impedance_controller(
        robot.model, burnish.ImpedanceSpec(burnish.PressingPath(normal_world=n, task=path.at, posture=q)))
    plant = burnish.make_ideal_plant(burnish.plant_model(robot.model, disturbances),
                                     burnish.plant_scene(nominal, disturbances))
    loop = burnish.ClosedLoop(plant, controller, disturbances)
    loop.reset(q)
    loop.run(2.5)
    return loop, n


def vectors(rows, name):
    return np.stack([rows[f"{name}_{axis}_world"] for axis in "xyz"], axis=1)


def test_metrics_match_the_rows_of_the_trace(robot, run):
    loop, n = run
    spec = burnish.MetricsSpec(start=1.2, end=2.2, normal_world=3.0 * n, average=0.0)
    metrics = burnish.measure(loop.trace, robot.model, spec)
    rows = loop.trace.array()
    rows = rows[(rows["time"] >= 1.2) & (rows["time"] <= 2.2)]
    assert metrics.rows == len(rows) and metrics.start == rows["time"][0]
    force = vectors(rows, "tool_force") @ n
    error = force - rows["target_force"]
    assert math.isclose(metrics.force_mean, force.mean(), rel_tol=1e-12)
    assert math.isclose(metrics.force_rmse, np.sqrt(np.mean(error**2)), rel_tol=1e-12)
    assert math.isclose(metrics.force_mae, np.abs(error).mean(), rel_tol=1e-12)
    assert math.isclose(metrics.force_peak, np.abs(error).max(), rel_tol=1e-12)
    assert math.isclose(metrics.force_rmse_raw, metrics.force_rmse, rel_tol=1e-9)
    across = vectors(rows, "tool") - vectors(rows, "target")
    across -= np.outer(across @ n, n)
    distance = np.linalg.norm(across, axis=1)
    assert math.isclose(metrics.position_rmse, np.sqrt(np.mean(distance**2)), rel_tol=1e-9)
    assert math.isclose(metrics.position_mean, distance.mean(), rel_tol=1e-9)
    estimate_error = (vectors(rows, "estimated_force") - vectors(rows, "tool_force")) @ n
    assert math.isclose(metrics.estimate_rmse, np.sqrt(np.mean(estimate_error**2)), rel_tol=1e-9)
    assert 0.1 < metrics.estimate_rmse < 0.3, "the error must be the noise of the force sensor"
    q = np.stack([rows["q_" + name] for name in robot.model.q_names], axis=1)
    margin = np.minimum(q - robot.model.q_lower, robot.model.q_upper - q).min(axis=0)
    assert math.isclose(metrics.joint_margin, margin.min(), rel_tol=1e-12)
    assert metrics.tightest_joint == robot.model.v_names[int(margin.argmin())]
    assert metrics.without_contact == 0.0 and metrics.impact_peak is not None
    assert metrics.solver is None


def test_invalid_metrics_spec_raises(robot, run):
    loop, n = run
    with pytest.raises(burnish.Error):
        burnish.measure(loop.trace, robot.model, burnish.MetricsSpec(start=100.0))
    with pytest.raises(burnish.Error, match="normal"):
        burnish.measure(loop.trace, robot.model, burnish.MetricsSpec(normal_world=[0, 0, 0]))
    with pytest.raises(burnish.Error, match="no column"):
        burnish.measure(burnish.Trace({"time": "s"}, [[0.0]]), robot.model)


def documented(spec):
    """Returns the text below each field of a dataclass."""
    body = ast.parse(inspect.getsource(spec)).body[0].body
    return {entry.target.id: " ".join(text.value.value.split())
            for entry, text in zip(body, body[1:])
            if isinstance(entry, ast.AnnAssign) and isinstance(text, ast.Expr)}


def test_figures_match_the_table_in_the_docs():
    specs = {"": report.Metrics, "solver": report.SolverFigures,
             "standing": report.StandingFigures, "ticks": polishing.TickTimes,
             "verdict": polishing.VerdictFigures,
             "rest": polishing.RestFigures, "hold": press_hold.HoldFigures,
             "push": push_wall.PushFigures, "sway": stand.SwayFigures}
    texts = {group: documented(spec) for group, spec in specs.items()}
    table = (DOCS / "polishing.md").read_text().split("<!-- figures -->")[1]
    rows = [line.strip("| ").split(" | ") for line in table.split("<!-- end")[0].splitlines()[3:]]
    of_runs = {"force_error_mean", "run_torque_margin", "run_limited_torque", "largest_command"}
    named = {name.strip("`"): ", ".join(filter(None, [cells[0].strip(), cells[2]]))
             for name, *cells in rows}
    assert len(named) > 40 and of_runs < set(named)
    for name, text in named.items():
        if name not in of_runs:
            *group, field = name.split(".")
            assert texts["".join(group)].pop(field) == text, name
    assert [field for spec_texts in texts.values() for field in spec_texts] == ["solver"]


def test_metrics_pickle_compare_and_print(robot, run):
    loop, n = run
    metrics = burnish.measure(loop.trace, robot.model, burnish.MetricsSpec(1.0, normal_world=n))
    assert pickle.loads(pickle.dumps(metrics)) == metrics
    assert metrics.replace(force_rmse=1.0) != metrics
    assert "force_rmse" in repr(metrics) and "force_rmse" in metrics.text()
    table = burnish.metrics_table([burnish.NamedMetrics("baseline", metrics),
                                   burnish.NamedMetrics("again", metrics)])
    lines = [line.split() for line in table.splitlines()]
    assert lines[0] == ["figure", "baseline", "again"]
    assert ["force_rmse", "N", *2 * [f"{metrics.force_rmse:.3f}"]] in lines
    assert len({len(line) for line in table.splitlines()}) == 1 and "solver" not in table


def test_copied_trace_gives_the_same_metrics(robot, run):
    loop, n = run
    rows = loop.trace.array()
    copied = burnish.Trace(loop.trace.units, np.array(rows.tolist()))
    assert copied == loop.trace
    spec = burnish.MetricsSpec(1.0, normal_world=n)
    assert burnish.measure(copied, robot.model, spec) == burnish.measure(loop.trace, robot.model, spec)
    assert pickle.loads(pickle.dumps(copied)) == copied
    with pytest.raises(burnish.Error, match="rows have 3 entries; wanted 2"):
        burnish.Trace({"a": "m", "b": "s"}, np.zeros((4, 3)))
    with pytest.raises(burnish.Error):
        burnish.Trace({"a,b": "m"})
    assert len(burnish.Trace()) == 0 and burnish.Trace({"a": "m"}).columns == ["a"]


def test_write_csv_gives_the_rows_of_the_trace(tmp_path, run):
    loop, _ = run
    loop.trace.write_csv(tmp_path / "trace.csv")
    head = (tmp_path / "trace.csv").read_text().splitlines()[0]
    assert head.startswith("time [s],phase [-],")
    read = np.genfromtxt(tmp_path / "trace.csv", delimiter=",", skip_header=1)
    assert np.array_equal(read, np.array(loop.trace.array().tolist()))


def test_plot_is_written_as_svg(tmp_path, run):
    loop, n = run
    spec = burnish.PlotSpec("force", [burnish.Panel(
        "along the normal", "time [s]", "force [N]",
        [burnish.Curve("measured", loop.trace["time"], loop.trace["measured_force_z_world"]),
         burnish.Curve("wanted", [0.0, 2.5], [15.0, 15.0], dashed=True)])])
    text = burnish.svg_plot(spec)
    assert text.startswith("<svg") and "time [s]" in text and "wanted" in text
    burnish.write_svg_plot(spec, tmp_path / "plot.svg")
    assert (tmp_path / "plot.svg").read_text() == text
    assert all(color.startswith("#") for color in burnish.plot_palette())
    with pytest.raises(burnish.Error, match="nowhere"):
        burnish.write_svg_plot(spec, tmp_path / "nowhere" / "plot.svg")
