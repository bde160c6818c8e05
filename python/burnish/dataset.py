"""Data sets of trajectories in HDF5, for learning.

Solutions of optimal control problems have gains, value functions and contact schedules. Closed-loop runs have
all signals.

    dataset.write_solutions("data.h5", "examples/problems/reaching.yaml", initial_states)
    dataset.write_runs("runs.h5", [polishing.make_task("table", seed=seed) for seed in range(20)])
    record = dataset.load("data.h5")[0]
    record.arrays["x"], record.arrays["K"]           # plain NumPy
    dataset.replay(record)                           # computes the record again

docs/campaigns.md lists the contents of a file. This module needs h5py (Debian: python3-h5py)."""

from __future__ import annotations

import importlib
import io
import os
import tempfile
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Dict, List, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import polishing
from ._core import DdpSolver, Error, Problem, __version__, make_guess, read_problem_file

__all__ = ["Record", "load", "make_run", "make_solution", "replay", "write", "write_runs", "write_solutions"]

FORMAT = "burnish dataset 1"

Array = NDArray[Any]
File = Union[str, Path]


@dataclass
class Record:
    """Solution or run: arrays, names of their columns, and the text that repeats it."""

    kind: str
    """"solution" or "run\""""
    text: str
    """Text of the problem file, or of the task with all keys"""
    arrays: Dict[str, Array]
    """Arrays by name; docs/campaigns.md lists the names"""
    names: Dict[str, List[str]]
    """Names of the columns of some arrays, by name of the array"""
    attributes: Dict[str, str] = field(default_factory=dict)
    """Outcome, version, and other data for replay()"""


def _h5py() -> Any:
    try:
        return importlib.import_module("h5py")
    except ImportError as missing:
        raise ImportError("burnish.dataset needs h5py (Debian: python3-h5py, or pip install h5py)") from missing


def _padded(rows: Sequence[ArrayLike]) -> Array:
    """Stacks arrays of different sizes, padded with NaN."""
    arrays = [np.asarray(row, dtype=np.float64) for row in rows]
    shape = [max(sizes) for sizes in zip(*(array.shape for array in arrays))]
    out = np.full([len(arrays), *shape], np.nan)
    for k, array in enumerate(arrays):
        out[(k, *(slice(0, size) for size in array.shape))] = array
    return out


def make_solution(problem_file: File, initial_state: Optional[ArrayLike] = None) -> Record:
    """Solves a problem and records the solution.

    Parameters
    ----------
    problem_file : str or Path
        Problem file.
    initial_state : array_like, shape (nx,), optional
        Initial state; default: the one of the file.

    Returns
    -------
    Record

    Raises
    ------
    Error
        If the file or its problem is invalid.
    """
    file = read_problem_file(problem_file)
    problem = Problem(file.spec)
    if initial_state is not None:
        problem.set_initial_state(initial_state)
    solver = DdpSolver(problem, file.solver)
    guess = make_guess(problem, file.guess)
    solver.set_guess(guess.xs, guess.us)
    summary = solver.solve()
    knots = range(problem.knots)
    xs, us = solver.xs, solver.us
    contacts = [contact.name for contact in problem.spec.contacts]
    stages = problem.stage_names
    held = {stage.name: set(stage.contacts) for stage in problem.spec.stages}
    rows: List[str] = []
    for k in knots:
        rows += [name for name in problem.force_names(k) if name not in rows]
    force = np.full((problem.knots, len(rows)), np.nan)
    for k in knots:
        values = problem.forces(k, xs[k], us[k, : problem.controls(k)])
        for name, value in zip(problem.force_names(k), values):  # NaN for contacts without a force
            force[k, rows.index(name)] = value
    arrays: Dict[str, Array] = {
        "time": np.array([problem.time_of(k) for k in range(problem.knots + 1)]),
        "x": xs,
        "u": _padded([us[k, : problem.controls(k)] for k in knots]),
        "force": force,
        "feedforward": _padded([solver.feedforward(k) for k in knots]),
        "K": _padded([solver.gain(k) for k in knots]),
        "Vx": _padded([solver.value_gradient(k) for k in range(problem.knots + 1)]),
        "Vxx": _padded([solver.value_hessian(k) for k in range(problem.knots + 1)]),
        "stage": np.array([problem.stage_of(k) for k in knots]),
        "contact": np.array([[name in held.get(stages[problem.stage_of(k)], ()) for name in contacts]
                             for k in knots], dtype=bool).reshape(problem.knots, len(contacts)),
        "cost": np.array(summary.cost),
    }
    words = {"x": problem.state_names, "u": problem.control_names, "force": rows, "stage": stages,
             "contact": contacts}
    return Record("solution", Path(problem_file).read_text(), arrays, words,
                  {"outcome": summary.reason.name.lower(), "burnish": __version__,
                   "file": str(Path(problem_file).resolve())})


_RUN_VIEWS = {"q": "q_", "v": "v_", "tau": "tau_applied_", "force": "tool_force_", "target": "target_"}


def make_run(task: polishing.Task, controller: str = "mpc", plant: Optional[str] = None,
             plan_rate: float = 20.0) -> Record:
    """Runs a polishing task and records all signals of every plant step, except measured times.

    Parameters
    ----------
    task : polishing.Task
    controller : str
        "mpc", "baseline" or "admittance".
    plant : str, optional
        "mujoco" or "ideal"; default: MuJoCo if this build has it, else ideal.
    plan_rate : float
        Rate at which plans are recorded [Hz].

    Returns
    -------
    Record

    Raises
    ------
    Error
        If the task is contradictory, or this build does not have the plant.
    """
    result = polishing.run(task, controller=controller, plant=plant, plan_rate=plan_rate)
    trace = result.trace
    columns = [name for name in trace.columns if name != "solve_time"]
    arrays: Dict[str, Array] = {"signals": np.stack([trace[name] for name in columns], axis=1)}
    names = {"signals": columns, "units": [trace.units[name] for name in columns]}
    for view, start in _RUN_VIEWS.items():
        names[view] = [name for name in columns if name.startswith(start)]
        arrays[view] = np.stack([trace[name] for name in names[view]], axis=1) if names[view] else np.empty(
            (len(trace), 0))
    plans = result.plans
    arrays.update(time=trace["time"], phase=trace["phase"].astype(np.int64),
                  contact=trace["in_contact"] != 0.0, plan_time=plans.time, plan_q=plans.q, plan_x=plans.x,
                  plan_u=plans.u, plan_K=plans.K, plan_Vx=plans.Vx, plan_Vxx=plans.Vxx)
    return Record("run", polishing.task_text(task), arrays, names,
                  {"outcome": result.outcome.partition(", simulated in")[0], "burnish": __version__,
                   "controller": controller, "plant": result.plant.name.lower(),
                   "plan_rate": repr(float(plan_rate))})


def replay(record: Record) -> Record:
    """Computes a record again, bit by bit equal on the same machine with the same version of burnish.

    Parameters
    ----------
    record : Record

    Returns
    -------
    Record

    Raises
    ------
    Error
        If a file that the record needs, such as its robot, is missing.
    """
    if record.kind == "run":
        task = _from_text(record, lambda file: polishing.read_task(file))
        return make_run(task, record.attributes["controller"], record.attributes["plant"],
                        float(record.attributes["plan_rate"]))
    start = record.arrays["x"][0]
    again: Record = _from_text(record, lambda file: make_solution(file, start))
    again.attributes["file"] = record.attributes["file"]
    return again


def _from_text(record: Record, use: Any) -> Any:
    """Calls `use` with the original file if its text is unchanged, else with a temporary copy. Paths in the file
    are relative to its folder."""
    own = Path(record.attributes.get("file", ""))
    if own.is_file() and own.read_text() == record.text:
        return use(own)
    with tempfile.TemporaryDirectory(prefix="burnish_") as folder:
        file = Path(folder) / (own.name or "task.yaml")
        file.write_text(record.text)
        return use(file)


def write(file: File, records: Sequence[Record]) -> None:
    """Writes records to a new file. If writing fails, no file is left.

    Parameters
    ----------
    file : str or Path
        HDF5 file; an existing file is replaced.
    records : sequence of Record

    Raises
    ------
    Error
        If the file cannot be written.
    """
    h5py = _h5py()
    data = io.BytesIO()
    with h5py.File(data, "w", track_order=True) as book:
        book.attrs["format"] = FORMAT
        book.attrs["burnish"] = __version__
        for number, record in enumerate(records):
            group = book.create_group(f"{record.kind}_{number:06d}", track_order=True)
            group.attrs["kind"] = record.kind
            group.attrs["text"] = record.text
            for key, value in record.attributes.items():
                group.attrs[key] = value
            for name, array in record.arrays.items():
                packed = {"compression": "gzip", "shuffle": True} if array.ndim > 1 and array.size > 1000 else {}
                group.create_dataset(name, data=array, track_times=False, **packed)
            for name, words in record.names.items():
                group.create_dataset(f"{name}_names", data=words, dtype=h5py.string_dtype(), track_times=False)
    target = Path(file)
    part = target.parent / f".{target.name}.{os.getpid()}.part"
    try:
        part.write_bytes(data.getvalue())
        part.replace(target)
    except OSError as error:
        part.unlink(missing_ok=True)
        raise Error(f"cannot write '{target}': {error.strerror}") from error


def write_solutions(file: File, problem_file: File, initial_states: Sequence[ArrayLike] = ()) -> List[Record]:
    """Solves a problem from several initial states with make_solution(), and writes the records.

    Parameters
    ----------
    file : str or Path
        HDF5 file.
    problem_file : str or Path
        Problem file.
    initial_states : sequence of array_like, shape (nx,)
        Initial states; empty: the one of the problem file.

    Returns
    -------
    list of Record

    Raises
    ------
    Error
        If the problem is invalid, or the file cannot be written.
    """
    records = [make_solution(problem_file, state) for state in initial_states] if len(initial_states) else [
        make_solution(problem_file)]
    write(file, records)
    return records


def write_runs(file: File, tasks: Sequence[polishing.Task], controller: str = "mpc",
               plant: Optional[str] = None, plan_rate: float = 20.0) -> List[Record]:
    """Runs tasks with make_run(), and writes the records.

    Parameters
    ----------
    file : str or Path
        HDF5 file.
    tasks : sequence of polishing.Task
    controller, plant, plan_rate
        Arguments of make_run().

    Returns
    -------
    list of Record

    Raises
    ------
    Error
        If a task is contradictory, or the file cannot be written.
    """
    records = [make_run(task, controller, plant, plan_rate) for task in tasks]
    write(file, records)
    return records


def load(file: File) -> List[Record]:
    """Reads all records of a file into memory.

    Parameters
    ----------
    file : str or Path
        HDF5 file.

    Returns
    -------
    list of Record

    Raises
    ------
    Error
        If the file cannot be read, or is not a data set of burnish.
    """
    h5py = _h5py()
    try:
        with h5py.File(file, "r") as book:
            if book.attrs.get("format") != FORMAT:
                raise Error(f"'{file}' is not a data set of burnish; wanted the format '{FORMAT}'")
            return [_read(book[name]) for name in sorted(book)]
    except OSError as error:
        raise Error(f"cannot read the data set '{file}': {error}") from error


def _read(group: Any) -> Record:
    arrays: Dict[str, Array] = {}
    names: Dict[str, List[str]] = {}
    for name, data in group.items():
        if name.endswith("_names"):
            names[name[: -len("_names")]] = [str(word) for word in data.asstr()[()]]
        else:
            arrays[name] = np.asarray(data[()])
    attributes = {key: str(value) for key, value in group.attrs.items() if key not in ("kind", "text")}
    return Record(str(group.attrs["kind"]), str(group.attrs["text"]), arrays, names, attributes)
