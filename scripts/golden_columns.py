"""Columns of the output files of runs, and comparison of the columns of two programs, for scripts/golden."""

import csv
import dataclasses
import itertools
import json
import math
import pathlib
import re

# Names of measured times, which differ from run to run.
TIMES = {"solve_time", "wall_time_s", "median_s", "p99_s", "maximum_s", "mean_s", "first_s", "late", "seconds"}
TIME_IN_TEXT = re.compile(r"simulated in [\d.]+ m?s")
NUMBER = re.compile(r"[-+]?\d[-+.\de]*")
FACTOR = 10.0  # largest rounding difference, relative to the effect of one unit in the last place of the initial q
AHEAD = 20  # largest number of rows by which a rounding difference may come sooner than that effect
FIGURE = 1e-7  # relative rounding difference of a figure in JSON, whose effect in nudged runs can be small by chance
MISSING = ["no such column"]

Columns = dict[str, list[str]]  # texts of each column, by its name with the unit


def renamed(name: str, names: dict[str, str]) -> str:
    for old, new in names.items():
        if old.endswith("*") and name.startswith(old[:-1]):
            return new[:-1] + name[len(old) - 1:]
        if name == old:
            return new
    return name


def text_of(value: str, names: dict[str, str]) -> str:
    """A word under its current name; of a sentence, only the numbers: wording is not a result."""
    return renamed(value, names) if " " not in value else " ".join(NUMBER.findall(TIME_IN_TEXT.sub("", value)))


def columns_of(file: pathlib.Path, names: dict[str, str]) -> Columns:
    """Columns of a CSV file and its number of rows. For JSON, one row with a column per value, named by its path."""
    found: Columns = {}
    if file.suffix == ".csv":
        with file.open(newline="") as lines:
            header, *rows = csv.reader(lines)
        for index, title in enumerate(header):
            name, space, unit = title.partition(" [")
            if name not in TIMES:
                found[renamed(name, names) + space + unit] = [row[index] for row in rows]
        return found | {"rows": [str(len(rows))]}

    def walk(value: object, path: str) -> None:
        if isinstance(value, dict):
            for key, part in value.items():
                if key not in TIMES:
                    walk(part, f"{path}.{renamed(key, names)}".removeprefix("."))
        elif isinstance(value, list):
            for index, part in enumerate(value):
                walk(part, f"{path}[{index}]")
        else:
            found[path] = [text_of(value, names) if isinstance(value, str) else json.dumps(value)]

    walk(json.loads(file.read_text()), "")
    return found


def unit_of(name: str, texts: list[str]) -> str:
    """Unit of a column. Columns of equal unit share their rounding. For integers and words, the name of the column."""
    if all(re.fullmatch(r"-?\d+|\D*", text) for text in texts):
        return name
    found = re.search(r" \[(.*)\]$|_(N|Nm|m|rad|s)$", name)
    return f"[{found[1] or found[2]}]" if found else "[]"


def distance(a: str, b: str) -> float:
    """Distance of two cells: infinite for different words, 0 for sentences that differ only in their numbers."""
    if a == b:
        return 0.0
    try:
        return abs(float(a) - float(b))
    except ValueError:
        a, b = (NUMBER.sub("#", text) for text in (a, b))
        return 0.0 if a == b else math.inf


@dataclasses.dataclass
class Difference:
    row: int
    column: str
    theirs: str
    ours: str
    explained: float = 0.0  # largest difference that rounding explains

    def __str__(self) -> str:
        off = distance(self.theirs, self.ours)
        return (f"{self.column}: {self.ours}, PARENT has {self.theirs}"
                + (f", {off:.2g} off" if 0 < off < math.inf else "")
                + (f", rounding explains {self.explained:.2g}" if self.explained else ""))


def first(found: list[Difference]) -> Difference | None:
    return min(found, key=lambda difference: difference.row) if found else None


def first_difference(theirs: Columns, ours: Columns) -> Difference | None:
    """First difference of bits, by row and then by column. New columns do not count."""
    found = []
    for name, column in theirs.items():
        if column != ours.get(name):
            pairs = enumerate(zip(column, ours.get(name, MISSING)))
            found += [Difference(row, name, a, b) for row, (a, b) in pairs if a != b][:1]
    return first(found)


def beyond_rounding(theirs: Columns, ours: Columns, nudged: list[Columns]) -> Difference | None:
    """First difference beyond rounding. The limit is FACTOR times the largest difference between PARENT's run and its
    nudged runs, over columns of the same unit and all rows up to AHEAD rows later."""
    units = {name: unit_of(name, column + ours.get(name, [])) for name, column in theirs.items()}
    rows = max(map(len, theirs.values()), default=0)
    largest = {unit: [0.0] * rows for unit in units.values()}
    for name, column in theirs.items():
        of_unit = largest[units[name]]
        for other in nudged:
            for row, (a, b) in enumerate(zip(column, other.get(name, []))):
                of_unit[row] = max(of_unit[row], distance(a, b))
    so_far: dict[str, list[float]] = {unit: [*itertools.accumulate(values, max)] for unit, values in largest.items()}
    found = []
    for name, column in theirs.items():
        for row, (a, b) in enumerate(zip(column, ours.get(name, MISSING))):
            explained = FACTOR * so_far[units[name]][min(row + AHEAD, rows - 1)]
            off = distance(a, b)
            if rows == 1 and 0 < off < math.inf:
                explained = max(explained, FIGURE * abs(float(a)))
            if not off <= explained:
                found.append(Difference(row, name, a, b, explained))
                break
    return first(found)


def nudge(text: str, section: str, towards: float) -> str:
    """Returns a YAML text whose numbers in the sections `section` are moved by one unit in the last place towards
    `towards`; 0 is moved by the unit in the last place of 1."""

    def moved(found: re.Match[str]) -> str:
        value = float(found[2])
        return found[1] + repr(math.nextafter(value, towards) if value else math.copysign(2.0**-52, towards))

    lines, indent = [], -1  # indentation of the section's name
    for line in text.splitlines(keepends=True):
        margin = len(line) - len(line.lstrip())
        if line.strip() and margin <= indent:
            indent = -1
        if indent < 0 and re.match(rf"\s*{section}:", line):
            indent = margin
        if indent >= 0:
            line = re.sub(r"(\w+: +)(-?\d[\d.]*(?:e[-+]?\d+)?)(?=\s*(?:[,}#]|$))", moved, line)
        lines.append(line)
    return "".join(lines)
