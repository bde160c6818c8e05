"""Errors, status codes, and recorded tables."""

from __future__ import annotations

import csv
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._core import Error, EvaluationError, Trace, describe

__all__ = ["Error", "EvaluationError", "Status", "Trace", "describe", "read_trace"]


def read_trace(file: str | Path) -> dict[str, NDArray[Any]]:
    """Reads a recorded table, such as trace.csv of a run or trajectory.csv of a solution.

    Parameters
    ----------
    file : str or Path
        CSV file. Its header has names with units in brackets.

    Returns
    -------
    dict of str to ndarray of shape (rows,)
        Columns by their names without units, in SI units. Empty cells are NaN. A column of text is an
        array of strings. `pandas.DataFrame(read_trace(file))` makes a data frame.

    Raises
    ------
    Error
        If the file has no header, or if a row and the header differ in their number of cells.
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


# scripts/describe inserts the described classes here.
