"""Figures with matplotlib: forces, paths and an overview of polishing runs, and solutions of problems.

forces() and paths() draw figures 2 and 4 of the paper; their argument is a run (RunResult) or a dict of runs by
name. overview() draws one run, solution() the solution of a solver. All functions draw into given axes or into a
new figure, and return an array of axes, one per panel: forces(runs)[0].figure.savefig("forces.png").
The colours suit people with colour vision deficiencies."""

from __future__ import annotations

import importlib
from typing import Any, Dict, List, Mapping, Optional, Tuple, Union

import numpy as np
from numpy.typing import NDArray

from ._core import DdpSolver
from .polishing import ControllerKind, RunResult, SurfacePath, named_surfaces

__all__ = ["PALETTE", "Runs", "forces", "overview", "paths", "solution"]

Runs = Union[RunResult, Mapping[str, RunResult]]
Array = NDArray[np.float64]

PALETTE = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9")
"""Colours of runs, in order (Okabe and Ito, 2008). Targets and limits are black and dashed."""

_RAMP, _TRACK, _RETREAT = 2.0, 3.0, 4.0  # values of Phase in a trace


def _pyplot() -> Any:
    try:
        return importlib.import_module("matplotlib.pyplot")
    except ImportError as missing:
        raise ImportError("burnish.plot needs matplotlib (Debian: python3-matplotlib, or pip "
                          "install matplotlib)") from missing


def _named(runs: Runs) -> Dict[str, RunResult]:
    return {"": runs} if isinstance(runs, RunResult) else dict(runs)


def _by_surface(runs: Dict[str, RunResult]) -> List[Tuple[str, Dict[str, RunResult]]]:
    """Groups runs by the orientation of their surfaces, with the name of the surface."""
    groups: List[Tuple[Array, str, Dict[str, RunResult]]] = []
    for name, result in runs.items():
        normal = np.asarray(result.setting.scene.tool().surface.normal)
        for other, _, group in groups:
            if np.allclose(normal, other, atol=1e-6):
                group[name] = result
                break
        else:
            groups.append((normal, _surface_name(normal), {name: result}))
    return [(name, group) for _, name, group in groups]


def _surface_name(normal: Array) -> str:
    for surface in named_surfaces():
        if np.allclose(normal, surface.normal_world / np.linalg.norm(surface.normal_world), atol=1e-6):
            return f"{surface.name}, normal {_vector(normal)}"
    return f"normal {_vector(normal)}"


def _vector(v: Array) -> str:
    return "(" + ", ".join(f"{x:.2g}" for x in np.round(v, 3) + 0.0) + ")"


def _axes(given: Any, count: int, size: Tuple[float, float], columns: int = 1) -> NDArray[Any]:
    """Axes to draw in: the given ones, or those of a new figure with `count` panels of `size` [inch]."""
    if given is not None:
        axes = np.atleast_1d(np.asarray(given, dtype=object)).ravel()
        if len(axes) != count:
            raise ValueError(f"plot: axes has {len(axes)} entries; wanted {count}, one per panel")
        return np.asarray(axes)
    rows = -(-count // columns)
    _, made = _pyplot().subplots(rows, columns, squeeze=False, constrained_layout=True,
                                 figsize=(columns * size[0], rows * size[1]))
    for axis in made.ravel()[count:]:
        axis.remove()
    return np.asarray(made.ravel()[:count])


def _along(result: RunResult, what: str, direction: Array) -> Array:
    """Component of a vector of the trace along a direction in the world."""
    trace = result.trace
    parts = np.stack([trace[f"{what}_{axis}_world"] for axis in "xyz"])
    return np.asarray(direction @ parts)


def _averaged(values: Array, dt: float) -> Array:
    """Moving mean over 10 ms around each row."""
    half = max(1, round(0.005 / dt))
    window, here = np.ones(2 * half), slice(half - 1, half - 1 + len(values))
    # Sums each window separately, because differences of running sums lose digits in long signals.
    sums, counts = (np.convolve(x, window)[here] for x in (values, np.ones(len(values))))
    return np.asarray(sums / counts)


def _time_step(result: RunResult) -> float:
    time = result.trace["time"]
    return float(time[1] - time[0]) if len(time) > 1 else 1.0


def _path_begin(result: RunResult) -> float:
    """Time of the beginning of the path [s]; the planned time if the path did not begin."""
    on_path = np.flatnonzero(result.trace["phase"] == _TRACK)
    return float(result.trace["time"][on_path[0]]) if len(on_path) else result.setting.ramp_end


def _finish(axis: Any, title: str, x: str, y: str, **legend: Any) -> None:
    """Adds labels, a grid, and a legend if a curve has a label."""
    axis.set_title(title, fontsize="medium")
    axis.set_xlabel(x)
    axis.set_ylabel(y)
    axis.grid(True, linewidth=0.4, alpha=0.5)
    for side in ("top", "right"):
        axis.spines[side].set_visible(False)
    if axis.get_legend_handles_labels()[1]:
        axis.legend(**{"fontsize": "small", "edgecolor": "none", "framealpha": 0.8, **legend})


def forces(runs: Runs, axes: Any = None, *, estimated: bool = False) -> NDArray[Any]:
    """Draws the normal force and its target over time (figure 2 of the paper).

    Each surface has a panel, and each run a curve. Time is relative to the beginning of the path.

    Parameters
    ----------
    runs : RunResult or mapping of str to RunResult
        One run, or runs by name.
    axes : Axes or sequence of Axes, optional
        Axes to draw in, one per surface.
    estimated : bool
        If True, draws the estimated force of the controller, else the mean of the true force over 10 ms.

    Returns
    -------
    ndarray of Axes, shape (surfaces,)

    Raises
    ------
    ValueError
        If the number of axes is wrong.
    """
    groups = _by_surface(_named(runs))
    panels = _axes(axes, len(groups), (7.0, 2.6))
    for axis, (surface, group) in zip(panels, groups):
        lines = {name: _force_over_time(result, estimated) for name, result in group.items()}
        for i, (name, (time, force, _)) in enumerate(lines.items()):
            what = "estimated" if estimated else "mean over 10 ms"
            axis.plot(time, force, color=PALETTE[i % len(PALETTE)], label=name or what,
                      linewidth=0.6 if estimated else 1.0)
        drawn: List[Tuple[Array, Array]] = []
        for time, _, target in lines.values():
            if any(_same_line((time, target), other) for other in drawn):
                continue
            axis.plot(time, target, "--", color="black", linewidth=1.0,
                      label=None if drawn else "target")
            drawn.append((time, target))
        _finish(axis, surface, "time on the path [s]", "normal force [N]")
    return panels


def _force_over_time(result: RunResult, estimated: bool) -> Tuple[Array, Array, Array]:
    """Returns time since the beginning of the path, force and target, from the ramp to the end of the path."""
    trace = result.trace
    normal = np.asarray(result.setting.surface_axes)[:, 2]
    force = _along(result, "estimated_force" if estimated else "tool_force", normal)
    shown = (trace["phase"] >= _RAMP) & (trace["phase"] < _RETREAT)
    if not estimated:
        force = _averaged(force, _time_step(result))
        # The last rows are left out, because their moving mean includes the retreat.
        shown[np.flatnonzero(shown)[-round(0.01 / _time_step(result)):]] = False
    return (trace["time"][shown] - _path_begin(result), force[shown], trace["target_force"][shown])


def _same_line(a: Tuple[Array, Array], b: Tuple[Array, Array]) -> bool:
    """Returns whether two targets differ by less than 0.5 N in their common time."""
    if not len(a[0]) or not len(b[0]):
        return False
    first, last = max(a[0][0], b[0][0]) + 0.02, min(a[0][-1], b[0][-1])
    t = np.linspace(first, last, 200)
    return bool(np.max(np.abs(np.interp(t, *a) - np.interp(t, *b))) < 0.5)


def paths(runs: Runs, axes: Any = None) -> NDArray[Any]:
    """Draws the paths of the tool and the target in the plane of the surface (figure 4 of the paper).

    Each surface has a panel with equal scales, and each run a curve.

    Parameters
    ----------
    runs : RunResult or mapping of str to RunResult
        One run, or runs by name.
    axes : Axes or sequence of Axes, optional
        Axes to draw in, one per surface.

    Returns
    -------
    ndarray of Axes, shape (surfaces,)

    Raises
    ------
    ValueError
        If the number of axes is wrong.
    """
    groups = _by_surface(_named(runs))
    panels = _axes(axes, len(groups), (5.0, 3.8), columns=2 if len(groups) > 1 else 1)
    for axis, (surface, group) in zip(panels, groups):
        for i, (name, result) in enumerate(group.items()):
            u, w = (1e3 * x for x in _in_plane(result, "tool"))
            axis.plot(u, w, color=PALETTE[i % len(PALETTE)], linewidth=1.2, label=name or "tool")
        first = next(iter(group.values()))
        target = 1e3 * _target_path(first)
        axis.plot(target[:, 0], target[:, 1], "--", color="black", linewidth=0.9, label="target")
        axis.set_aspect("equal", adjustable="datalim")
        tangents = np.asarray(first.setting.surface_axes).T
        _finish(axis, surface, f"along {_vector(tangents[0])} [mm]",
                f"along {_vector(tangents[1])} [mm]", loc="upper left",
                bbox_to_anchor=(1.0, 1.0))
    return panels


def _in_plane(result: RunResult, what: str) -> Tuple[Array, Array]:
    """Positions along the two tangents, relative to the centre of the path [m]."""
    on_path = result.trace["phase"] == _TRACK
    axes, center = np.asarray(result.setting.surface_axes), np.asarray(result.setting.p_center)
    u, w = (
        _along(result, what, axes[:, i])[on_path] - axes[:, i] @ center for i in range(2)
    )
    return u, w


def _target_path(result: RunResult) -> Array:
    task = result.task
    return SurfacePath(task.path).positions(np.linspace(0.0, task.polish_duration, 2000))


def overview(result: RunResult, axes: Any = None) -> NDArray[Any]:
    """Draws one run: normal force, path error, torques relative to their limits, computing times of plans.

    Parameters
    ----------
    result : RunResult
    axes : sequence of Axes, optional
        Four axes to draw in.

    Returns
    -------
    ndarray of Axes, shape (4,)

    Raises
    ------
    ValueError
        If the number of axes is not 4.
    """
    panels = _axes(axes, 4, (6.0, 2.6), columns=2)
    trace = result.trace
    _draw_force(panels[0], result)
    u, w = _in_plane(result, "tool")
    u_target, w_target = _in_plane(result, "target")
    time = trace["time"]
    on_path = time[trace["phase"] == _TRACK]
    panels[1].plot(on_path, 1e3 * np.hypot(u - u_target, w - w_target), color=PALETTE[0], linewidth=0.8)
    _finish(panels[1], "path error", "time [s]", "distance [mm]")
    panels[1].set_ylim(bottom=0.0)
    _draw_torques(panels[2], result)
    _draw_plans(panels[3], result)
    return panels


def _draw_force(axis: Any, result: RunResult) -> None:
    trace = result.trace
    normal = np.asarray(result.setting.surface_axes)[:, 2]
    force = _averaged(_along(result, "tool_force", normal), _time_step(result))
    if result.controller == ControllerKind.MPC:
        axis.plot(trace["time"], _along(result, "estimated_force", normal), color=PALETTE[4],
                  linewidth=0.6, label="estimated")
    axis.plot(trace["time"], force, color=PALETTE[0], linewidth=0.9, label="mean over 10 ms")
    axis.plot(trace["time"], trace["target_force"], "--", color="black", linewidth=0.9, label="target")
    _finish(axis, "normal force", "time [s]", "force [N]")


def _draw_torques(axis: Any, result: RunResult) -> None:
    model, trace = result.setting.robot.model, result.trace
    for i, (name, limit) in enumerate(zip(model.v_names, model.effort_limit)):
        if np.isfinite(limit) and limit > 0.0:
            axis.plot(trace["time"], 100.0 * trace[f"tau_applied_{name}"] / limit, label=name,
                      color=PALETTE[i % len(PALETTE)], linewidth=0.8,
                      linestyle="-" if i < len(PALETTE) else ":")
    for side in (-100.0, 100.0):
        axis.axhline(side, linestyle="--", color="black", linewidth=0.9)
    _finish(axis, "joint torques", "time [s]", "torque / limit [%]",
            fontsize="x-small", ncol=2, loc="upper right", bbox_to_anchor=(1.0, 0.93))


def _draw_plans(axis: Any, result: RunResult) -> None:
    trace, task = result.trace, result.task
    planned = (trace["tick"] != 0.0) & (trace["solve_time"] > 0.0)
    if not planned.any():
        axis.text(0.5, 0.5, "no plans: this controller does not optimize", ha="center", va="center",
                  transform=axis.transAxes)
        axis.set(xticks=[], yticks=[], title="computing time")
        return
    axis.semilogy(trace["time"][planned], 1e3 * trace["solve_time"][planned], ".", markersize=1.5,
                  color=PALETTE[0], rasterized=True, label="plan")
    axis.axhline(1e3 / task.update_rate, linestyle="--", color="black", linewidth=0.9,
                 label="update period")
    _finish(axis, "computing time", "time [s]", "time per plan [ms]")


def solution(solver: DdpSolver, axes: Any = None) -> NDArray[Any]:
    """Draws the solution of a solver over time: coordinates q, velocities v, controls u.

    Controls are constant between knots. Bounds of the first knot are dashed if they are within 120 % of the largest
    control.

    Parameters
    ----------
    solver : DdpSolver
        Solver with a solution.
    axes : sequence of Axes, optional
        Three axes to draw in.

    Returns
    -------
    ndarray of Axes, shape (3,)

    Raises
    ------
    ValueError
        If the number of axes is not 3.
    """
    panels = _axes(axes, 3, (6.0, 2.4))
    problem = solver.problem
    nq, nv = problem.model.nq, problem.model.nv
    times = np.array([problem.time_of(knot) for knot in range(problem.knots + 1)])
    parts = ((0, nq, "coordinates", "q [rad or m]"), (nq, nq + nv, "velocities", "v [rad/s or m/s]"))
    for axis, (begin, end, title, label) in zip(panels, parts):
        for i, name in enumerate(problem.state_names[begin:end]):
            axis.plot(times, solver.xs[:, begin + i], label=name, **_line_of(i))
        _finish(axis, title, "time [s]", label, **_beside())
    bounds = []
    for i, name in enumerate(problem.control_names):
        held = np.append(solver.us[:, i], np.nan)
        panels[2].step(times, held, where="post", label=name, **_line_of(i))
        for side in (problem.control_lower(0), problem.control_upper(0)):
            if side is not None and i < len(side):
                bounds.append((float(side[i]), _line_of(i)["color"]))
    max_shown = 1.2 * np.nanmax(np.abs(solver.us), initial=0.0)
    for value, colour in bounds:
        if abs(value) <= max_shown:
            panels[2].axhline(value, linestyle="--", linewidth=0.7, color=colour)
    _finish(panels[2], "controls", "time [s]", "u [Nm or N]", **_beside())
    return panels


def _line_of(i: int) -> Dict[str, Any]:
    """Colour and dashes of curve number i."""
    return {"color": PALETTE[i % len(PALETTE)], "linewidth": 0.9,
            "linestyle": ("-", ":", "--", "-.")[i // len(PALETTE) % 4]}


def _beside() -> Dict[str, Any]:
    """Options of a legend to the right of its panel."""
    return {"fontsize": "x-small", "loc": "upper left", "bbox_to_anchor": (1.0, 1.0)}
