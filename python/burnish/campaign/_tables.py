"""Files of a campaign: tables as CSV and HDF5, and a page with distributions."""

from __future__ import annotations

import csv
import html
import importlib
import io
import json
import math
import os
import shlex
import subprocess
from pathlib import Path
from typing import Any, Callable, Dict, List, Sequence, Tuple

import burnish
import numpy as np

from ._results import CampaignError, RunFolder, write_whole
from ._sweep import Row, SweepResult, bare, unit


def columns_of(result: SweepResult) -> List[Tuple[str, str, Callable[[Row], Any]]]:
    """Name, unit and value of each column."""
    columns: List[Tuple[str, str, Callable[[Row], Any]]] = [("run", "", lambda row: row.number)]
    units = result.sweep.task.units()
    for key in result.rows[0].point if result.rows else []:
        columns.append((key, units.get(key, ""), lambda row, key=key: row.point[key]))  # type: ignore[misc]
    columns.append(("succeeded", "", lambda row: row.outcome.succeeded))
    for figure in result.figures:
        columns.append((bare(figure), unit(figure), lambda row, figure=figure:  # type: ignore[misc]
                        row.outcome.figures.get(figure, math.nan)))
    columns.append(("outcome", "", lambda row: row.outcome.outcome))
    if result.kernels:
        columns.append(("kernels", "", lambda row: row.outcome.kernels))
    columns.append(("result", "", lambda row: row.run.name()))
    return columns


def csv_text(result: SweepResult) -> str:
    """Returns CSV text with the header `name [unit],...`; the cell of a missing figure is empty."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    columns = columns_of(result)
    writer.writerow([f"{name} [{of}]" if of else name for name, of, _ in columns])

    def cell(value: Any) -> str:
        if isinstance(value, bool):
            return "yes" if value else "no"
        if isinstance(value, float):
            return "" if math.isnan(value) else repr(value)
        return value if isinstance(value, str) else json.dumps(value)

    for row in result.rows:
        writer.writerow([cell(value(row)) for _, _, value in columns])
    return text.getvalue()


def write_hdf5(result: SweepResult, file: Path) -> bool:
    """Writes the table: a data set per column, with its unit as an attribute, and the text of the campaign. Returns
    False if h5py is not installed."""
    try:
        h5py: Any = importlib.import_module("h5py")
    except ImportError:
        return False
    data = io.BytesIO()
    with h5py.File(data, "w", track_order=True) as book:
        book.attrs["campaign"] = result.sweep.text
        book.attrs["burnish"] = burnish.__version__
        book.attrs["stopped"] = result.stopped
        for name, of, value in columns_of(result):
            cells = [value(row) for row in result.rows]
            if all(isinstance(cell, (bool, int, float)) for cell in cells):
                made = book.create_dataset(name, data=np.array(cells), track_times=False)
            else:
                words = [cell if isinstance(cell, str) else json.dumps(cell) for cell in cells]
                made = book.create_dataset(name, data=words, dtype=h5py.string_dtype(), track_times=False)
            made.attrs["unit"] = of
    write_whole(file, data.getvalue())
    return True


def statistics_of(values: Sequence[float]) -> Dict[str, float]:
    """Mean with the half width of its 95 % interval, median, 95 % quantile, and largest value."""
    array = np.array(values)
    half = 1.96 * array.std(ddof=1) / math.sqrt(len(array)) if len(array) > 1 else math.nan
    return {"runs": len(array), "mean": float(array.mean()), "+-": float(half), "median": float(np.median(array)),
            "95 %": float(np.quantile(array, 0.95)), "largest": float(array.max())}


def repeat_words(row: Row, folder: str) -> List[str]:
    """Command that repeats a run with its full record, in the folder of its task file."""
    return ["burnish", row.run.words[0], f"{folder}/task.yaml", *row.run.words[1:], "--out", f"{folder}/run"]


def write_worst(result: SweepResult, program: str, folder: RunFolder) -> List[Tuple[Row, str]]:
    """Writes full records of the worst runs, each in a folder with its task; returns the commands."""
    made = []
    for row in result.worst():
        place = folder.path / "worst" / f"run_{row.number}"
        place.mkdir(parents=True, exist_ok=True)
        write_whole(place / "task.yaml", row.run.text.encode())
        words = repeat_words(row, f"worst/run_{row.number}")
        # Paths in the task are relative to the working folder; the task file is in the folder of the campaign.
        done = subprocess.run([program, words[1], str(place / "task.yaml"), *row.run.words[1:], "--quiet", "--force",
                               "--out", str(place / "run")], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                              text=True)
        if done.returncode not in (0, 1):
            raise CampaignError(f"run {row.number} could not be repeated for its record: {done.stderr.strip()}")
        made.append((row, shlex.join(words)))
    return made


_STYLE = """:root{--page:#f4f5f7;--card:#fff;--ink:#16202a;--muted:#586472;--line:#dce1e7;--grid:#e9ecf0;--accent:#0072b2}
@media(prefers-color-scheme:dark){:root{--page:#0e1216;--card:#161b21;--ink:#e9edf1;--muted:#9ba7b3;--line:#2a323b;
--grid:#232a32;--accent:#56b4e9}}
body{margin:0;padding:24px;background:var(--page);color:var(--ink);font:14px/1.45 system-ui,sans-serif}
main{max-width:1200px;margin:auto}section{background:var(--card);border:1px solid var(--line);border-radius:10px;
padding:16px;margin:16px 0}h1{font-size:20px}h2{font-size:15px;margin:0 0 8px}table{border-collapse:collapse}
td,th{padding:3px 12px 3px 0;text-align:right}td:first-child,th:first-child{text-align:left}th{color:var(--muted);
font-weight:500}pre{overflow:auto;margin:0}svg{margin:4px}.bar{fill:var(--accent)}.dot{fill:var(--accent);opacity:.55}
.axis{stroke:var(--line)}text{fill:var(--muted);font-size:11px}.title{fill:var(--ink)}"""


_FOR_PEOPLE = {"m": (1e3, "mm"), "rad": (180.0 / math.pi, "deg")}
_WIDTH, _HEIGHT, _LEFT, _RIGHT, _TOP, _BOTTOM = 330, 200, 46, 320, 24, 158  # pixels


def _scale(of: str) -> Tuple[float, str]:
    """Factor to the display unit, and the display unit."""
    return _FOR_PEOPLE.get(of, (1.0, of))


def _label(name: str, of: str) -> str:
    return f"{name} [{of}]" if of else name


def _shown_figure(figure: str) -> Tuple[float, str]:
    factor, of = _scale(unit(figure))
    return factor, _label(bare(figure), of)


def _ticks(low: float, high: float) -> List[float]:
    """Three to six round numbers within a range."""
    step = 10.0 ** math.floor(math.log10((high - low) / 2.5))
    step *= next(m for m in (1.0, 2.0, 5.0, 10.0) if (high - low) / (m * step) <= 5.0)
    first = math.ceil(low / step - 1e-9)
    return [i * step for i in range(first, math.floor(high / step + 1e-9) + 1)]


class _Axes:
    """Panel with ticks: positions of values, and the SVG of the axes."""

    def __init__(self, x: Tuple[float, float], y: Tuple[float, float]) -> None:
        self.x, self.y = (self._widened(*range_) for range_ in (x, y))

    @staticmethod
    def _widened(low: float, high: float) -> Tuple[float, float]:
        return (low, high) if high > low else (low - 0.5 * (abs(low) or 1.0), low + 0.5 * (abs(low) or 1.0))

    def at_x(self, value: float) -> float:
        return _LEFT + (_RIGHT - _LEFT) * (value - self.x[0]) / (self.x[1] - self.x[0])

    def at_y(self, value: float) -> float:
        return _BOTTOM - (_BOTTOM - _TOP) * (value - self.y[0]) / (self.y[1] - self.y[0])

    def svg(self, title: str, label: str, inner: str) -> str:
        across = "".join(
            f'<line class="axis" x1="{_LEFT}" x2="{_RIGHT}" y1="{self.at_y(t):.1f}" y2="{self.at_y(t):.1f}"/>'
            f'<text x="{_LEFT - 5}" y="{self.at_y(t) + 4:.1f}" text-anchor="end">{t:.6g}</text>'
            for t in _ticks(*self.y))
        along = "".join(
            f'<line class="axis" x1="{self.at_x(t):.1f}" x2="{self.at_x(t):.1f}" y1="{_BOTTOM}" y2="{_BOTTOM + 4}"/>'
            f'<text x="{self.at_x(t):.1f}" y="{_BOTTOM + 16}" text-anchor="middle">{t:.6g}</text>'
            for t in _ticks(*self.x))
        middle = (_LEFT + _RIGHT) // 2
        return (f'<svg width="{_WIDTH}" height="{_HEIGHT}" role="img" aria-label="{html.escape(title)}">'
                f'<text class="title" x="{_LEFT}" y="14">{html.escape(title)}</text>{across}{along}{inner}'
                f'<text x="{middle}" y="{_BOTTOM + 34}" text-anchor="middle">{html.escape(label)}</text></svg>')


def histogram(figure: str, values: Sequence[float]) -> str:
    """Returns the histogram of a figure as SVG."""
    factor, label = _shown_figure(figure)
    shown = [factor * value for value in values]
    axes = _Axes((min(shown), max(shown)), (0.0, 1.0))
    counts, edges = np.histogram(shown, bins=min(30, max(5, int(math.sqrt(len(shown))))), range=axes.x)
    axes.y = (0.0, float(counts.max()))
    bars = "".join(
        f'<rect class="bar" x="{axes.at_x(a):.1f}" width="{max(axes.at_x(b) - axes.at_x(a) - 1, 1):.1f}" '
        f'y="{axes.at_y(c):.1f}" height="{_BOTTOM - axes.at_y(c):.1f}"/>'
        for c, a, b in zip(counts, edges, edges[1:]) if c)
    return axes.svg(f"number of runs, {len(shown)} in total", label, bars)


def scatter(label: str, factor: float, figure: str, pairs: Sequence[Tuple[float, float]]) -> str:
    """Returns a plot of a figure over a key as SVG; `factor` converts the key to its display unit."""
    scale, title = _shown_figure(figure)
    x, y = factor * np.array(pairs).T[0], scale * np.array(pairs).T[1]
    axes = _Axes((float(x.min()), float(x.max())), (float(y.min()), float(y.max())))
    dots = "".join(f'<circle class="dot" r="2.5" cx="{axes.at_x(a):.1f}" cy="{axes.at_y(b):.1f}"/>'
                   for a, b in list(zip(x, y))[:3000])
    return axes.svg(title, label, dots)


def _point_text(point: Dict[str, Any], units: Dict[str, str]) -> str:
    """Text of a point, such as "force 20 N, disturbances.seed 7"."""
    def value(given: Any) -> str:
        return f"{given:.6g}" if isinstance(given, float) else given if isinstance(given, str) else json.dumps(given)

    return ", ".join(" ".join(filter(None, [key, value(given), units.get(key, "")]))
                     for key, given in point.items())


_SHOWN = ("force_rmse_N", "force_peak_N", "position_rmse_m", "without_contact", "impact_peak_N", "slip_m")


def page_text(result: SweepResult, worst: List[Tuple[Row, str]], command: str) -> str:
    """Returns the page of a campaign as HTML that needs no other file."""
    rows, figures = result.rows, [f for f in result.figures if result.values(f)]
    succeeded, units = sum(row.outcome.succeeded for row in rows), result.sweep.task.units()
    body = [f"<h1>{html.escape(result.sweep.name)}</h1><p>{len(rows)} runs, {succeeded} succeeded. "
            f"{html.escape(result.stopped)}</p>"]
    if result.kernels:
        body.append(f"<p>The runs used different kernels, whose results differ in their last digits: "
                    f"{html.escape(result.kernels)}.</p>")
    if figures:
        head = list(statistics_of([0.0, 1.0]))
        lines = ""
        for figure in figures:
            factor, label = _shown_figure(figure)
            cells = statistics_of(result.values(figure)).items()
            lines += f"<tr><td>{html.escape(label)}</td>" + "".join(
                f"<td>{v:.4g}</td>" if name == "runs" else f"<td>{factor * v:.4g}</td>" for name, v in cells) + "</tr>"
        body.append("<section><h2>Statistics over all runs that have the figure</h2><table><tr><th></th>" + "".join(
            f"<th>{h}</th>" for h in head) + f"</tr>{lines}</table><p>+-: half width of the mean's 95 % interval."
            "</p></section>")
        shown = [f for f in _SHOWN if f in figures] or figures[:6]
        body.append("<section><h2>Distributions</h2>" + "".join(
            histogram(f, result.values(f)) for f in shown) + "</section>")
        plots = ""
        for key in rows[0].point:
            if len({json.dumps(row.point[key]) for row in rows}) < 2:
                continue
            factor, of = _scale(units.get(key, ""))
            for figure in shown[:4]:
                pairs = [(float(row.point[key]), row.outcome.figures[figure]) for row in rows
                         if figure in row.outcome.figures and isinstance(row.point[key], (int, float))]
                plots += scatter(_label(key, of), factor, figure, pairs) if pairs else ""
        if plots:
            body.append(f"<section><h2>Figures over varied keys</h2>{plots}</section>")
    if worst:
        body.append("<section><h2>Worst runs</h2>" + "".join(
            f'<p>Run {row.number}: {html.escape(row.outcome.outcome)} '
            f'{html.escape(_point_text(row.point, units))} (<a href="worst/run_{row.number}/run/">record</a>)</p>'
            f"<pre>{html.escape(words)}</pre>" for row, words in worst) + "</section>")
    failed = [row for row in rows if not row.outcome.succeeded]
    if failed:
        body.append("<section><h2>Runs that did not succeed</h2>" + "".join(
            f"<p>Run {row.number}: {html.escape(row.outcome.outcome)}</p>" for row in failed[:100]) + (
            f"<p>and {len(failed) - 100} more</p>" if len(failed) > 100 else "") + "</section>")
    body.append(f"<section><h2>The campaign</h2><pre>{html.escape(result.sweep.text)}</pre>"
                f"<p>burnish {burnish.__version__}</p><pre>{html.escape(command)}</pre></section>")
    return (f"<!doctype html><html lang='en'><meta charset='utf-8'><title>{html.escape(result.sweep.name)}</title>"
            f"<style>{_STYLE}</style><main>{''.join(body)}</main></html>\n")


def write_sweep(result: SweepResult, program: str, folder: RunFolder, command: str) -> List[str]:
    """Writes all files of a campaign; returns their names."""
    os.makedirs(folder.path, exist_ok=True)
    write_whole(folder.path / "campaign.yaml", result.sweep.text.encode())
    write_whole(folder.path / "results.csv", csv_text(result).encode())
    names = ["campaign.yaml", "results.csv"]
    if write_hdf5(result, folder.path / "results.h5"):
        names.append("results.h5")
    worst = write_worst(result, program, folder)
    write_whole(folder.path / "results.html", page_text(result, worst, command).encode())
    return names + ["results.html"] + ["worst/"] * bool(worst)
