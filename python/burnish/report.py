"""Metrics, plots."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import List, Optional

from numpy.typing import ArrayLike

from . import _core
from ._core import measure, metrics_table, plot_palette, svg_plot, write_svg_plot
from ._spec import Spec, empty, items, vector

__all__ = ["Curve", "Metrics", "MetricsSpec", "NamedMetrics", "Panel", "PlotSpec", "SolverFigures",
           "measure", "metrics_table", "plot_palette", "svg_plot", "write_svg_plot"]


@dataclass(eq=False, repr=False)
class MetricsSpec(Spec):
    """What of a trace is measured."""

    start: float = 0.0
    """s, of the window"""
    end: float = math.inf
    """s, of the window"""
    normal_world: ArrayLike = vector(0.0, 0.0, 1.0)
    """3, of the surface as it is, towards the robot; any length but zero. The force is measured along
    it, the position across it."""
    average: float = 0.010
    """s, of the moving average of the force, centred; 0: none"""


@dataclass(eq=False, repr=False)
class SolverFigures(Spec):
    """Over the control ticks of the window that solved something."""

    updates: int = 0
    """plans that were made"""
    median: float = 0.0
    """s, median computing time of a plan"""
    p99: float = 0.0
    """s, computing time that 99 % of the plans stay below"""
    maximum: float = 0.0
    """s, longest computing time of a plan"""
    mean_iterations: float = 0.0
    """solver iterations per plan, mean"""
    missed_deadlines: int = 0
    """plans that came later than they were due"""


@dataclass(eq=False, repr=False)
class Metrics(Spec):
    """How well a run polished: all of the window unless it says otherwise, on true forces and
    positions, SI units."""

    start: float = 0.0
    """s, of the first row within the window"""
    end: float = 0.0
    """s, of the last row within the window"""
    rows: int = 0
    """of the trace within the window"""
    average: float = 0.0
    """s, that averaged forces are means over, by whole rows; 0: of one row each"""
    force_mean: float = 0.0
    """N, mean normal force"""
    force_mae: float = 0.0
    """N, mean absolute error of the force's moving mean"""
    force_rmse: float = 0.0
    """N, root mean square error of the force's moving mean"""
    force_peak: float = 0.0
    """N, largest absolute error of the force's moving mean"""
    force_rmse_raw: float = 0.0
    """N, root mean square error of the force in every row"""
    force_peak_raw: float = 0.0
    """N, largest absolute error of the force in any row"""
    estimate_rmse: float = 0.0
    """N, root mean square error of what the controller believes the normal force to be"""
    without_contact: float = 0.0
    """share of the time without contact"""
    impact_peak: Optional[float] = None
    """N, largest normal force in the 50 ms from the first contact of the run on"""
    overshoot: Optional[float] = None
    """N, largest excess of the force's moving mean over the target, from the end of the ramp to the
    window; at least 0"""
    position_mean: float = 0.0
    """m, mean distance to the target across the normal"""
    position_rmse: float = 0.0
    """m, root mean square distance to the target across the normal"""
    position_p95: float = 0.0
    """m, distance to the target across the normal that is not exceeded 95 % of the time"""
    orientation_drift: float = 0.0
    """rad, largest rotation of the tool since the window began"""
    joint_margin: float = 0.0
    """rad, smallest distance of a joint to its limit (m where it slides)"""
    tightest_joint: str = ""
    """whose margin that is; empty without limits"""
    torque_margin: float = 1.0
    """share of a joint's effort limit that was never used, smallest"""
    tightest_torque: str = ""
    """whose margin that is; empty without limits"""
    limited_torque: float = 0.0
    """share of the time with a joint at its effort limit"""
    solver: Optional[SolverFigures] = None
    """where a controller reports solve times"""

    def text(self) -> str:
        """All figures, one per line: name, value, unit, what it means."""
        return _core.metrics_text(self)


@dataclass(eq=False, repr=False)
class NamedMetrics(Spec):
    name: str
    metrics: Metrics


@dataclass(eq=False, repr=False)
class Curve(Spec):
    """One line. Points that are not finite interrupt it."""

    name: str = ""
    """in the legend; empty: not listed"""
    x: ArrayLike = empty()
    y: ArrayLike = empty()
    color: int = -1
    """of the palette; -1: the next one"""
    dashed: bool = False
    """limits and targets"""


@dataclass(eq=False, repr=False)
class Panel(Spec):
    """Axes with curves in them."""

    title: str = ""
    x_label: str = ""
    """with its unit, such as "time [s]\""""
    y_label: str = ""
    curves: List[Curve] = items()
    equal_aspect: bool = False
    """a metre is as long upwards as to the right"""
    log_y: bool = False
    """values that are not positive are left out"""


@dataclass(eq=False, repr=False)
class PlotSpec(Spec):
    """Line plots as an SVG file that any browser shows."""

    title: str = ""
    panels: List[Panel] = items()
    columns: int = 1
    """panels beside each other"""
    panel_width: float = 640.0
    """px, the legend included"""
    panel_height: float = 240.0
    """px"""
