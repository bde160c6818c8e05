"""Metrics and plots of runs."""

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


# scripts/describe inserts the described classes here.


@dataclass(eq=False, repr=False)
class Metrics(Spec):
    _brief = True

    def text(self) -> str:
        """Returns a text with a line per figure: name, value, unit, meaning."""
        return _core.metrics_text(self)
