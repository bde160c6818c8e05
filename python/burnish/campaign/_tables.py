"""What a campaign leaves: a table as CSV and HDF5, and a page with distributions."""

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
    columns.append(("done", "", lambda row: row.outcome.done))
    for figure in result.figures:
        columns.append((bare(figure), unit(figure), lambda row, figure=figure:  # type: ignore[misc]
                        row.outcome.figures.get(figure, math.nan)))
    columns.append(("outcome", "", lambda row: row.outcome.outcome))
    if result.kernels:
        columns.append(("kernels", "", lambda row: row.outcome.kernels))
    columns.append(("result", "", lambda row: row.run.name()))
    return columns


def csv_text(result: SweepResult) -> str:
    """First line `name [unit],...`; a figure that a run lacks is nothing."""
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
    """The table with a data set per column, its unit an attribute, and the campaign's text. False where
    h5py is not installed."""
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
    """mean with the half width of its 95 % interval, median, 95 % and worst (largest)."""
    array = np.array(values)
    half = 1.96 * array.std(ddof=1) / math.sqrt(len(array)) if len(array) > 1 else math.nan
    return {"runs": len(array), "mean": float(array.mean()), "+-": float(half), "median": float(np.median(array)),
            "95 %": float(np.quantile(array, 0.95)), "largest": float(array.max())}


def repeat_words(row: Row, folder: str) -> List[str]:
    """The command that makes a run again with its full record, beside its task's file."""
    return ["burnish", row.run.words[0], f"{folder}/task.yaml", *row.run.words[1:], "--out", f"{folder}/run"]


def write_worst(result: SweepResult, program: str, folder: RunFolder) -> List[Tuple[Row, str]]:
    """Full records of the worst runs, in folders of their own with their tasks; the commands."""
    made = []
    for row in result.worst():
        place = folder.path / "worst" / f"run_{row.number}"
        place.mkdir(parents=True, exist_ok=True)
        write_whole(place / "task.yaml", row.run.text.encode())
        words = repeat_words(row, f"worst/run_{row.number}")
        # Files that a task names are seen from here, its own from the campaign's folder.
        done = subprocess.run([program, words[1], str(place / "task.yaml"), *row.run.words[1:], "--quiet", "--force",
                               "--out", str(place / "run")], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                              text=True)
        if done.returncode not in (0, 1):
            raise CampaignError(f"the record of run {row.number} was refused: {done.stderr.strip()}")
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
.axis{stroke:var(--line)}text{fill:var(--muted);font-size:11px}"""


def _frame(title: str, label: str, low: float, high: float, inner: str) -> str:
    return (f'<svg width="270" height="190" role="img" aria-label="{html.escape(title)}">'
            f'<text x="10" y="14">{html.escape(title)}</text>{inner}'
            f'<line class="axis" x1="10" y1="160" x2="260" y2="160"/>'
            f'<text x="10" y="174">{low:.4g}</text><text x="260" y="174" text-anchor="end">{high:.4g}</text>'
            f'<text x="135" y="187" text-anchor="middle">{html.escape(label)}</text></svg>')


def _label(figure: str) -> str:
    return f"{bare(figure)} [{unit(figure)}]" if unit(figure) else figure


def histogram(figure: str, values: Sequence[float]) -> str:
    """An SVG."""
    low, high = min(values), max(values)
    counts, _ = np.histogram(values, bins=min(30, max(5, int(math.sqrt(len(values))))),
                             range=(low, high) if high > low else (low - 0.5, low + 0.5))
    width = 250 / len(counts)
    bars = "".join(f'<rect class="bar" x="{10 + i * width:.1f}" y="{160 - 135 * c / counts.max():.1f}" '
                   f'width="{width - 1:.1f}" height="{135 * c / counts.max():.1f}"/>' for i, c in enumerate(counts))
    return _frame(f"{bare(figure)}, {len(values)} runs", _label(figure), low, high, bars)


def scatter(key: str, figure: str, pairs: Sequence[Tuple[float, float]]) -> str:
    """An SVG of a figure over a key."""
    x, y = np.array(pairs).T
    wide, tall = (float(np.ptp(x)) or 1.0), (float(np.ptp(y)) or 1.0)
    dots = "".join(f'<circle class="dot" r="2.5" cx="{10 + 250 * (a - x.min()) / wide:.1f}" '
                   f'cy="{155 - 130 * (b - y.min()) / tall:.1f}"/>' for a, b in pairs[:3000])
    return _frame(f"{bare(figure)}: {y.min():.4g} to {y.max():.4g} {unit(figure)}", key, float(x.min()),
                  float(x.max()), dots)


_SHOWN = ("force_rmse_N", "force_peak_N", "position_rmse_m", "without_contact", "impact_peak_N", "slip_m")


def page_text(result: SweepResult, worst: List[Tuple[Row, str]], command: str) -> str:
    """A page that needs nothing besides itself."""
    rows, figures = result.rows, [f for f in result.figures if result.values(f)]
    done = sum(row.outcome.done for row in rows)
    body = [f"<h1>{html.escape(result.sweep.name)}</h1><p>{len(rows)} runs, {done} done. "
            f"{html.escape(result.stopped)}</p>"]
    if result.kernels:
        body.append(f"<p>Kernels of several kinds made them, which differ in their last digits: "
                    f"{html.escape(result.kernels)}.</p>")
    if figures:
        head = list(statistics_of([0.0, 1.0]))
        lines = "".join(f"<tr><td>{html.escape(_label(f))}</td>" + "".join(
            f"<td>{v:.4g}</td>" for v in statistics_of(result.values(f)).values()) + "</tr>" for f in figures)
        body.append("<section><h2>Over all runs that have the figure</h2><table><tr><th></th>" + "".join(
            f"<th>{h}</th>" for h in head) + f"</tr>{lines}</table><p>+-: half width of the mean's 95 % interval."
            "</p></section>")
        shown = [f for f in _SHOWN if f in figures] or figures[:6]
        body.append("<section><h2>Distributions</h2>" + "".join(
            histogram(f, result.values(f)) for f in shown) + "</section>")
        plots, units = "", result.sweep.task.units()
        for key in rows[0].point:
            for figure in shown[:4]:
                pairs = [(float(row.point[key]), row.outcome.figures[figure]) for row in rows
                         if figure in row.outcome.figures and isinstance(row.point[key], (int, float))]
                label = f"{key} [{units[key]}]" if key in units else key
                plots += scatter(label, figure, pairs) if pairs else ""
        if plots:
            body.append(f"<section><h2>Over what varies</h2>{plots}</section>")
    if worst:
        body.append("<section><h2>Worst runs</h2>" + "".join(
            f'<p>Run {row.number}: {html.escape(row.outcome.outcome)} '
            f'{html.escape(json.dumps(row.point))} (<a href="worst/run_{row.number}/run/">its record</a>)</p>'
            f"<pre>{html.escape(words)}</pre>" for row, words in worst) + "</section>")
    failed = [row for row in rows if not row.outcome.done]
    if failed:
        body.append("<section><h2>Runs that were not done</h2>" + "".join(
            f"<p>Run {row.number}: {html.escape(row.outcome.outcome)}</p>" for row in failed[:100]) + (
            f"<p>and {len(failed) - 100} more</p>" if len(failed) > 100 else "") + "</section>")
    body.append(f"<section><h2>The campaign</h2><pre>{html.escape(result.sweep.text)}</pre>"
                f"<p>burnish {burnish.__version__}</p><pre>{html.escape(command)}</pre></section>")
    return (f"<!doctype html><html lang='en'><meta charset='utf-8'><title>{html.escape(result.sweep.name)}</title>"
            f"<style>{_STYLE}</style><main>{''.join(body)}</main></html>\n")


def write_sweep(result: SweepResult, program: str, folder: RunFolder, command: str) -> List[str]:
    """All of it; the names of the files."""
    os.makedirs(folder.path, exist_ok=True)
    write_whole(folder.path / "campaign.yaml", result.sweep.text.encode())
    write_whole(folder.path / "results.csv", csv_text(result).encode())
    names = ["campaign.yaml", "results.csv"]
    if write_hdf5(result, folder.path / "results.h5"):
        names.append("results.h5")
    worst = write_worst(result, program, folder)
    write_whole(folder.path / "results.html", page_text(result, worst, command).encode())
    return names + ["results.html"] + ["worst/"] * bool(worst)
