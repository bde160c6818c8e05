"""Values of the keys of a task in a campaign: lists, ranges, distributions, Sobol points."""

from __future__ import annotations

import importlib
import itertools
import math
import statistics
import zlib
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Mapping, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from .. import _core
from ._results import CampaignError

Point = Dict[str, Any]
"""Values of keys of a task, by their paths, such as "path.radius\""""

max_runs = 100_000


def nearest(word: str, known: List[str]) -> str:
    """End of a message: "; did you mean 'x'?", or the known words."""
    return _core.did_you_mean(word, known) or f"; known are {', '.join(known)}"


def only(where: str, given: Mapping[str, Any], known: List[str]) -> None:
    """Raises CampaignError for an unknown key."""
    for key in given:
        if key not in known:
            raise CampaignError(f"{where}: key '{key}' is unknown{nearest(str(key), known)}")


def number(where: str, value: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        raise CampaignError(f"{where} is {value!r}; wanted a number")
    return float(value)


def count(where: str, value: Any, minimum: int) -> int:
    if isinstance(value, bool) or not isinstance(value, int) or value < minimum:
        raise CampaignError(f"{where} is {value!r}; wanted an integer of at least {minimum}")
    return value


def _pair(where: str, value: Any, first: str, second: str) -> Tuple[float, float]:
    if not isinstance(value, list) or len(value) != 2:
        raise CampaignError(f"{where} is {value!r}; wanted [{first}, {second}]")
    return number(where, value[0]), number(where, value[1])


def _span(where: str, value: Any) -> Tuple[float, float]:
    low, high = _pair(where, value, "lowest", "highest")
    if not low < high:
        raise CampaignError(f"{where} goes from {low:g} to {high:g}; wanted the lower limit first")
    return low, high


def _range(where: str, given: Mapping[str, Any]) -> List[Any]:
    only(where, given, ["from", "to", "count", "step", "log"])
    if "from" not in given or "to" not in given or ("count" in given) == ("step" in given):
        raise CampaignError(f"{where} is a range with {', '.join(given)}; wanted 'from', 'to', and one of 'count' "
                            f"and 'step'")
    low, high = _span(where, [given["from"], given["to"]])
    log = given.get("log", False)
    if log and (low <= 0 or "step" in given):
        raise CampaignError(f"{where} is a logarithmic range from {low:g}; wanted a lower limit above 0, and 'count'")
    if "step" in given:
        step = number(where + ".step", given["step"])
        if not 0 < step <= high - low:
            raise CampaignError(f"{where}.step is {step:g}; wanted a step above 0 and at most {high - low:g}")
        values = [low + step * i for i in range(int((high - low) / step + 1e-9) + 1)]
    else:
        n = count(where + ".count", given["count"], 2)
        even = np.geomspace(low, high, n) if log else np.linspace(low, high, n)
        values = [float(v) for v in even]
        values[-1] = high
    return [round(v, 15) for v in values]


Draw = Callable[[float], Any]
"""Inverse distribution function: maps a number from 0 to 1 to a value"""


def _choice(where: str, value: Any) -> Draw:
    if not isinstance(value, list) or not value:
        raise CampaignError(f"{where} is {value!r}; wanted a list of values")
    values: List[Any] = value
    return lambda u: values[min(int(u * len(values)), len(values) - 1)]


def _distribution(where: str, kind: str, value: Any) -> Draw:
    if kind == "choice":
        return _choice(where, value)
    if kind == "normal":
        mean, spread = _pair(where, value, "mean", "standard deviation")
        if not spread > 0:
            raise CampaignError(f"{where} has a standard deviation of {spread:g}; wanted a value above 0")
        normal = statistics.NormalDist(mean, spread)
        return lambda u: normal.inv_cdf(min(max(u, 1e-12), 1 - 1e-12))
    low, high = _span(where, value)
    if kind == "uniform":
        return lambda u: low + (high - low) * u
    if low <= 0:
        raise CampaignError(f"{where} is log-uniform from {low:g}; wanted a lower limit above 0")
    return lambda u: low * (high / low) ** u


_DISTRIBUTIONS = ["uniform", "log_uniform", "normal", "choice"]


@dataclass
class Values:
    """Values of the varied keys: listed values, and distributions with the number of samples."""

    listed: Dict[str, List[Any]]
    drawn: Dict[str, Draw]
    samples: int
    sobol: bool
    seed: int

    def points(self) -> List[Point]:
        """All points: the grid of the listed values, with the last key varying fastest, times the samples."""
        grid = [dict(zip(self.listed, values)) for values in itertools.product(*self.listed.values())]
        samples = self._samples()
        if len(grid) * len(samples) > max_runs:
            raise CampaignError(f"the campaign has {len(grid) * len(samples)} points; wanted at most {max_runs}")
        return [{**lists, **sample} for lists in grid for sample in samples]

    def _samples(self) -> List[Point]:
        if not self.drawn:
            return [{}]
        unit = self._sobol() if self.sobol else self._independent()
        return [{key: draw(float(u)) for (key, draw), u in zip(self.drawn.items(), row)} for row in unit]

    def _independent(self) -> NDArray[np.float64]:
        # One random stream per key, so that the samples of a key do not depend on the other keys.
        columns = [np.random.Generator(np.random.PCG64([self.seed, zlib.crc32(key.encode())])).random(self.samples)
                   for key in self.drawn]
        return np.stack(columns, axis=1)

    def _sobol(self) -> NDArray[np.float64]:
        try:
            qmc: Any = importlib.import_module("scipy.stats.qmc")
        except ImportError as missing:
            raise CampaignError("Sobol points need SciPy, which is not installed (Debian: apt install "
                                "python3-scipy); wanted SciPy, or sobol: false") from missing
        # Draws a power of 2 of points, and returns the first ones.
        power = max(0, math.ceil(math.log2(self.samples)))
        points: NDArray[np.float64] = qmc.Sobol(len(self.drawn), seed=self.seed).random_base2(power)
        return points[:self.samples]


def read_values(vary: Any, samples: Any) -> Values:
    """Reads `vary` and `samples` of a campaign. Raises CampaignError for contradictions."""
    if vary is None:
        vary = {}
    if not isinstance(vary, dict):
        raise CampaignError(f"'vary' is {vary!r}; wanted keys of the task with their values")
    values = Values({}, {}, 0, False, 0)
    for key, given in vary.items():
        _read_key(str(key), given, values)
    keys = [*values.listed, *values.drawn]
    for key, other in itertools.permutations(keys, 2):
        if other.startswith(key + "."):
            raise CampaignError(f"'vary' has '{key}' and '{other}', which is a part of '{key}'; wanted one of them")
    _read_samples(samples, values)
    return values


def _read_key(key: str, given: Any, values: Values) -> None:
    where = f"vary.{key}"
    if isinstance(given, list):
        if not given:
            raise CampaignError(f"{where} is an empty list; wanted values")
        values.listed[key] = given
    elif isinstance(given, dict) and ("from" in given or "to" in given):
        values.listed[key] = _range(where, given)
    elif isinstance(given, dict) and len(given) == 1:
        (kind, value), = given.items()
        only(where, given, [*_DISTRIBUTIONS, "from"])
        values.drawn[key] = _distribution(f"{where}.{kind}", kind, value)
    else:
        raise CampaignError(f"{where} is {given!r}; wanted a list, a range (from, to, count or step), or one of "
                            f"{', '.join(_DISTRIBUTIONS)}")


def _read_samples(given: Optional[Any], values: Values) -> None:
    if given is None:
        if values.drawn:
            raise CampaignError(f"'{next(iter(values.drawn))}' has a distribution, and key 'samples' is missing; "
                                f"wanted samples: {{count: N}}")
        return
    given = {"count": given} if isinstance(given, int) else given
    if not isinstance(given, dict):
        raise CampaignError(f"'samples' is {given!r}; wanted a number, or the keys 'count', 'sobol' and 'seed'")
    only("samples", given, ["count", "sobol", "seed"])
    if not values.drawn:
        raise CampaignError("'samples' is given, and no key has a distribution; wanted one, such as "
                            "force: {uniform: [20, 40]}")
    values.samples = count("samples.count", given.get("count"), 1)
    if values.samples > max_runs:
        raise CampaignError(f"samples.count is {values.samples}; wanted at most {max_runs}")
    values.sobol = bool(given.get("sobol", False))
    values.seed = count("samples.seed", given.get("seed", 0), 0)
