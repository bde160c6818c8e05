"""Plots: panels, lines, legends and files."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")

import matplotlib.pyplot as plt

import burnish
from burnish import plot, polishing, residual


@pytest.fixture(scope="module")
def runs():
    def run(surface, controller):
        return polishing.run(surface, controller=controller, plant="ideal", polish_duration=0.6,
                             overrides=["path.start_up=0.3", "path.radius=0.02"], update_rate=200.0)

    return {f"{s}, {c}": run(s, c) for s in ("table", "board") for c in ("mpc", "baseline")}


@pytest.fixture(autouse=True)
def no_figure_stays():
    yield
    plt.close("all")


def labels(axis):
    return [line.get_label() for line in axis.get_lines() if not line.get_label().startswith("_")]


def line(axis, label):
    return next(line for line in axis.get_lines() if line.get_label() == label)


def legend(axis):
    return [text.get_text() for text in axis.get_legend().get_texts()]


def test_forces_have_a_panel_per_surface_and_a_line_per_run(runs):
    axes = plot.forces(runs)
    assert len(axes) == 2
    assert [axis.get_title() for axis in axes] == ["table, normal (0, 0, 1)", "board, normal (-1, 0, 0)"]
    assert legend(axes[0]) == ["table, mpc", "table, baseline", "target"]
    assert legend(axes[1]) == ["board, mpc", "board, baseline", "target"]
    assert axes[0].get_ylabel() == "normal force [N]" and axes[0].get_xlabel() == "time on the path [s]"


def test_forces_match_the_trace(runs):
    result = runs["board, mpc"]
    axis = plot.forces(result)[0]
    assert labels(axis) == ["mean over 10 ms", "target"]
    drawn, target = line(axis, "mean over 10 ms"), line(axis, "target")
    time = drawn.get_xdata()
    on_path = result.trace["time"][result.trace["phase"] == 3.0]
    assert time[0] < 0.0 and 0.58 < time[-1] <= on_path[-1] - on_path[0]
    late = time > 0.35
    assert np.mean(drawn.get_ydata()[late]) == pytest.approx(30.0, abs=1.0)
    np.testing.assert_allclose(target.get_ydata()[late], 30.0)
    force = -result.trace["tool_force_x_world"]  # the normal points out of the board
    row = np.searchsorted(result.trace["time"], on_path[0] + 0.4)
    mean = force[row - 10:row + 10].mean()
    at = np.searchsorted(time, 0.4 - 1e-9)
    assert drawn.get_ydata()[at] == pytest.approx(mean, abs=1e-9)


def test_estimated_forces_match_the_trace(runs):
    result = runs["table, mpc"]
    drawn = line(plot.forces(result, estimated=True)[0], "estimated").get_ydata()
    shown = (result.trace["phase"] >= 2.0) & (result.trace["phase"] < 4.0)
    np.testing.assert_array_equal(drawn, result.trace["estimated_force_z_world"][shown])


def test_paths_are_near_the_target_with_equal_scales(runs):
    axes = plot.paths(runs)
    assert len(axes) == 2 and legend(axes[0]) == ["table, mpc", "table, baseline", "target"]
    assert all(axis.get_aspect() == 1.0 for axis in axes)
    target, tool = line(axes[0], "target").get_xydata(), line(axes[0], "table, mpc").get_xydata()
    assert np.max(np.hypot(*target.T)) == pytest.approx(20.0, abs=0.1)
    nearest = np.min(np.linalg.norm(tool[::20, None] - target[None], axis=2), axis=1)
    assert 0.0 < np.max(nearest) < 1.5
    assert axes[1].get_xlabel() == "along (0, -1, 0) [mm]" and axes[1].get_ylabel() == "along (0, 0, 1) [mm]"


def test_overview_has_force_path_torques_and_times(runs):
    axes = plot.overview(runs["table, mpc"])
    assert [axis.get_title() for axis in axes] == [
        "normal force", "path error", "joint torques", "computing time"]
    assert legend(axes[0]) == ["estimated", "mean over 10 ms", "target"]
    assert legend(axes[2]) == runs["table, mpc"].setting.robot.model.v_names
    assert axes[3].get_yscale() == "log"
    solved = (runs["table, mpc"].trace["solve_time"] > 0.0).sum()
    assert 0 < len(line(axes[3], "plan").get_xdata()) <= solved
    without = plot.overview(runs["table, baseline"])
    assert without[3].get_legend() is None and "no plans" in without[3].texts[0].get_text()


def test_given_axes_are_used_and_returned(runs):
    figure, axes = plt.subplots(1, 2)
    drawn = plot.forces(runs["table, mpc"], axes=axes[0])
    assert drawn[0] is axes[0] and not axes[1].get_lines()
    both = plot.paths(runs, axes=axes)
    assert list(both) == list(axes) and both[0].figure is figure
    with pytest.raises(ValueError, match="axes has 1 entries; wanted 2"):
        plot.forces(runs, axes=axes[0])


def test_lines_of_runs_differ_in_colour(runs):
    axis = plot.forces({str(i): r for i, r in enumerate([runs["table, mpc"]] * 6)})[0]
    assert len({l.get_color() for l in axis.get_lines() if l.get_linestyle() == "-"}) == 6


def test_run_that_never_reached_its_path_is_drawn():
    stopped = polishing.run("table", plant="ideal", progress=lambda t, end: t < 0.2)
    for draw in (plot.forces, plot.paths, plot.overview):
        assert len(draw(stopped)) >= 1


def test_figures_are_saved_as_files(runs, tmp_path):
    for ending in ("png", "svg", "pdf"):
        file = tmp_path / f"force.{ending}"
        plot.forces(runs)[0].figure.savefig(file)
        assert file.stat().st_size > 5000


def test_package_imports_without_matplotlib():
    code = ("import sys; sys.modules['matplotlib'] = None; sys.modules['matplotlib.pyplot'] = None\n"
            "import burnish\n"
            "burnish.polishing.Task(); burnish.plot.PALETTE\n"
            "try: burnish.plot._pyplot()\n"
            "except ImportError as missing: print(missing)")
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert "burnish.plot needs matplotlib" in done.stdout


def test_solution_has_a_line_per_entry():
    model = burnish.load_robot("arm7").model
    spec = burnish.ProblemSpec(
        model, initial_state=np.zeros(14),
        stages=[burnish.Stage("move", step=0.05, costs=[burnish.CostTerm(residual.State()),
                                                        burnish.CostTerm(residual.Control())])],
        horizon=[burnish.HorizonSegment("move", 4)])
    solver = burnish.DdpSolver(burnish.Problem(spec))
    solver.solve()
    axes = plot.solution(solver)
    assert [axis.get_title() for axis in axes] == ["coordinates", "velocities", "controls"]
    problem = solver.problem
    assert labels(axes[0]) == list(problem.state_names[:7])
    assert labels(axes[2]) == list(problem.control_names)
    first = line(axes[1], problem.state_names[7])
    np.testing.assert_allclose(first.get_xdata(), [0.0, 0.05, 0.1, 0.15, 0.2])
    np.testing.assert_array_equal(first.get_ydata(), solver.xs[:, 7])
    control = line(axes[2], problem.control_names[3])
    np.testing.assert_array_equal(control.get_ydata()[:-1], solver.us[:, 3])
