"""Errors, statuses, records of runs."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._core import Error, EvaluationError, Trace, describe

__all__ = ["Error", "EvaluationError", "Status", "Trace", "describe", "read_trace"]


def read_trace(file: str | Path) -> dict[str, NDArray[Any]]:
    """Reads a table that a run or a solution left, such as trace.csv or trajectory.csv.

    Parameters
    ----------
    file
        The CSV file, whose header has names with units in brackets.

    Returns
    -------
    dict of str to ndarray of shape (rows,)
        Columns by their names without units, in SI units; empty cells are NaN. Columns that hold
        text are arrays of strings. `pandas.DataFrame(read_trace(file))` is the table.

    Raises
    ------
    Error
        If the file has no header, or a row does not have as many cells as the header.
    """
    with open(file, newline="", encoding="utf-8") as stream:
        header, *rows = list(csv.reader(stream)) or [[]]
    if not header:
        raise Error(f"{file}: the table has no header")
    for number, row in enumerate(rows, 2):
        if len(row) != len(header):
            raise Error(f"{file}: line {number} has {len(row)} cells; the header has {len(header)}")
    columns = zip(*rows) if rows else [()] * len(header)
    return {name.split(" [")[0]: _numbers_or_texts(cells)
            for name, cells in zip(header, columns)}


def _numbers_or_texts(cells: tuple[str, ...]) -> NDArray[Any]:
    try:
        return np.array([float(cell) if cell else np.nan for cell in cells])
    except ValueError:
        return np.array(cells)


# Described classes stand here (scripts/describe).
