"""Metrics, plots."""

from __future__ import annotations

from dataclasses import dataclass

from . import _core
from ._core import (
    measure,
    measure_standing,
    metrics_table,
    plot_palette,
    svg_plot,
    write_svg_plot,
)
from ._spec import Spec

__all__ = ["Curve", "Metrics", "MetricsSpec", "NamedMetrics", "Panel", "PlotSpec", "SolverFigures",
           "StandingFigures", "measure", "measure_standing", "metrics_table", "plot_palette", "svg_plot", "write_svg_plot"]


# Described classes stand here (scripts/describe).


@dataclass(eq=False, repr=False)
class Metrics(Spec):
    _brief = True

    def text(self) -> str:
        """All figures, one per line: name, value, unit, what it means."""
        return _core.metrics_text(self)
