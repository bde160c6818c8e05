"""Tuning: the optimum, its assessment on test runs, figures that must not get worse, invalid input."""

from __future__ import annotations

import importlib.util
import json
import math
import subprocess
import sys
from pathlib import Path

import pytest

from burnish import _core, campaign
from burnish.campaign import _tune
from burnish.campaign._results import RunFolder
from burnish.campaign._tasks import Machine, Outcome

TASKS = Path(__file__).resolve().parents[2] / "tasks"
has_nlopt = importlib.util.find_spec("nlopt") is not None
has_scipy = importlib.util.find_spec("scipy") is not None
either = pytest.mark.skipif(not (has_nlopt or has_scipy),
                            reason="neither NLopt nor SciPy is installed (python3-nlopt)")


class Made(Machine):
    """Machine whose figures are formulas: the force error is least at a weight of 10, the slip grows with
    the weight, the speed has no effect, and friction acts as noise."""

    kernels = ""

    def __init__(self):
        super().__init__("nothing")
        self.tasks = []

    def make(self, runs, keep):
        for index, run in enumerate(runs):
            task = _core.parse_yaml(run.text)
            self.tasks.append(task)
            weight, friction = task["controller"]["posture_weight"], task["surface"]["friction"]
            figures = {"force_rmse_N": 1.0 + (math.log10(weight) - 1.0) ** 2 + 0.01 * friction,
                       "slip_m": 1e-3 * (2.0 + math.log10(weight)), "moved_aside": weight}
            done = weight < 60
            keep(index, Outcome(done, "held" if done else "fault", figures if done else {},
                                {"computing_s": 0.1}, kernels=self.kernels))


def plan(**more):
    return {"task": str(TASKS / "press_hold" / "arm7.yaml"),
            "tune": {"controller.posture_weight": {"from": 0.1, "to": 100, "log": True},
                     "phases.approach_speed": {"from": 0.01, "to": 0.05}},
            "minimise": "force_rmse", "vary": {"surface.friction": {"uniform": [0.1, 0.5]}},
            "train": {"samples": 3}, "test": {"samples": 6}, "evaluations": 40, **more}


def tuned(tmp_path, mixed=False, **more):
    machine = Made()
    with RunFolder(tmp_path / "out", "", (tmp_path / "out").exists()) as folder:
        result = _tune.tune(_tune.Tuner(_tune.read_tuning(plan(**more)), machine, folder, mixed))
        _tune.write_tuned(result, folder)
    return result, machine


def row(result, figure):
    return next(each for each in result.table if each["figure"] == figure)


@either
def test_tuned_values_are_better_on_unseen_runs(tmp_path):
    result, machine = tuned(tmp_path)
    assert result.better
    assert 7 < result.best["controller.posture_weight"] < 14
    assert len(result.evaluated) <= 40
    force = row(result, "force_rmse_N")
    assert force["verdict"] == "better" and abs(force["change"] + 1.0) < 0.05 and force["half"] < 0.05
    assert row(result, "moved_aside")["verdict"] == "higher"
    # The test runs differ from the training runs.
    train, test = ({point["surface.friction"] for point in points} for points in (result.tuning.train, result.tuning.test))
    assert not train & test and len(test) == 6
    # The report distinguishes a key without effect from a key with an effect.
    weight, speed = result.matters
    assert weight["verdict"] == "worse" and speed.get("verdict", "no sure difference") == "no sure difference"
    # The tuned task has these values, and the report has the verdict and the tables.
    task = _core.read_yaml(tmp_path / "out" / "tuned.yaml")
    assert task["controller"]["posture_weight"] == result.best["controller.posture_weight"] and task["surface"]["friction"] == 0
    report = (tmp_path / "out" / "tuning.md").read_text()
    for words in ("significantly better on the test runs", "| controller.posture_weight | 1 |", "| force_rmse [N] (minimised) |"):
        assert words in report
    evaluations = (tmp_path / "out" / "evaluations.csv").read_text()
    assert evaluations.count("\n") == len(result.evaluated) + 1
    # A repeated tuning reads the existing results, makes no run, and has the same result.
    again, machine = tuned(tmp_path)
    assert not machine.tasks and again.best == result.best and again.table == result.table


@either
def test_weighted_sum_of_figures_is_minimised(tmp_path):
    # With x = log10(weight), (x - 1)^2 + (2 + x) is least at 1/2, and the force error alone at 1.
    result, _ = tuned(tmp_path, minimise={"force_rmse": 1, "slip": 1000})
    assert 2.5 < result.best["controller.posture_weight"] < 4.0
    total = row(result, "1 force_rmse + 1000 slip")
    assert total["verdict"] == "better"
    parts = [row(result, figure)["tuned"] for figure in ("force_rmse_N", "slip_m")]
    assert abs(total["tuned"] - parts[0] - 1000 * parts[1]) < 1e-12
    assert "| 1 force_rmse + 1000 slip (minimised) |" in (tmp_path / "out" / "tuning.md").read_text()


@either
def test_not_worse_figure_does_not_get_worse(tmp_path):
    result, _ = tuned(tmp_path, not_worse="slip")
    assert result.best["controller.posture_weight"] <= 1.0 + 1e-9 and not result.better
    assert "keep the original task" in _tune.report_text(result)
    result, _ = tuned(tmp_path, not_worse="slip", slack=0.3)
    assert 2.0 < result.best["controller.posture_weight"] < 4.1 and result.better
    assert row(result, "slip_m")["verdict"] == "within the slack"


class Divided(Made):
    """On hard ground a lower weight is better; on soft ground, where errors are large, a higher one."""

    def make(self, runs, keep):
        def kept(index, outcome):
            task = _core.parse_yaml(runs[index].text)
            log = math.log10(task["controller"]["posture_weight"])
            hard = task["surface"]["stiffness"] > 2e5
            outcome.figures["force_rmse_N"] = 1.0 + 0.5 * (log + 0.3) ** 2 if hard else 9.0 + (log - 1.0) ** 2
            return keep(index, outcome)

        super().make(runs, kept)


@either
def test_groups_of_runs_are_not_traded_off(tmp_path, monkeypatch):
    monkeypatch.setitem(globals(), "Made", Divided)
    ground = {"vary": {"surface.friction": {"uniform": [0.1, 0.5]}, "surface.stiffness": [1e5, 1e6]}}
    together, _ = tuned(tmp_path / "together", **ground)
    assert together.best["controller.posture_weight"] > 2.0 and not together.groups
    apart, _ = tuned(tmp_path / "apart", **ground, per="surface.stiffness", slack=1e-6)
    assert 0.4 < apart.best["controller.posture_weight"] <= 1.01
    assert list(apart.groups) == ["surface.stiffness 100000.0", "surface.stiffness 1000000.0"]
    report = _tune.report_text(apart)
    assert "Figures on test runs, by group" in report and "| surface.stiffness 1000000.0 |" in report
    with pytest.raises(campaign.CampaignError, match="'per' names 'surface.stifness', which is not in 'vary'; did you mean"):
        tuned(tmp_path / "no", **ground, per=["surface.stifness"])


class Unseen(Made):
    """From seed 100 on, the slip rises with the weight on soft ground and falls faster on hard ground;
    below seed 100 it does not depend on the weight."""

    def make(self, runs, keep):
        def kept(index, outcome):
            task = _core.parse_yaml(runs[index].text)
            seed = task["disturbances"]["seed"]
            log = math.log10(task["controller"]["posture_weight"])
            slope = 0.0 if seed < 100 else -2.0 if task["surface"]["stiffness"] > 2e5 else 1.0
            outcome.figures["slip_m"] = 1e-3 * (5.0 + slope * log + 0.01 * (seed % 7))
            return keep(index, outcome)

        super().make(runs, kept)


@either
def test_groups_of_test_runs_are_not_traded_off(tmp_path, monkeypatch):
    monkeypatch.setitem(globals(), "Made", Unseen)
    ground = {"vary": {"surface.stiffness": [1e5, 1e6]}, "not_worse": "slip",
              "train": {"seeds": {"first": 0, "count": 3}},
              "test": {"seeds": {"first": 100, "count": 6}}}
    together, _ = tuned(tmp_path / "together", **ground)
    assert together.better and row(together, "slip_m")["verdict"] != "worse"
    apart, _ = tuned(tmp_path / "apart", **ground, per="surface.stiffness")
    assert row(apart, "slip_m")["verdict"] != "worse" and not apart.better
    assert {name: [(each["figure"], each["verdict"]) for each in rows]
            for name, rows in apart.groups.items()} == {
        "surface.stiffness 100000.0": [("force_rmse_N", "better"), ("slip_m", "worse")],
        "surface.stiffness 1000000.0": [("force_rmse_N", "better"), ("slip_m", "better")]}
    report = _tune.report_text(apart).splitlines()
    lines = [line for line in report if line.startswith("| surface.stiffness")]
    assert [line.split(" | ")[1] for line in lines] == ["force_rmse [N]", "slip [m]"] * 2
    assert [line.endswith("| worse |") for line in lines] == [False, True, False, False]


class Changing(Made):
    """Machine that makes the first set of runs with other kernels than the rest."""

    @property
    def kernels(self):
        return "AVX2" if len(self.tasks) <= 3 else "AVX-512"


def results(tmp_path):
    files = (tmp_path / "out" / "runs").iterdir()
    return [file for file in files if not file.name.endswith(".times.json")]


@either
def test_mixed_kernels_within_a_tuning_raise(tmp_path, monkeypatch):
    monkeypatch.setitem(globals(), "Made", Changing)
    words = "different processors .1 with AVX-512, 3 with AVX2.*or --mixed"
    with pytest.raises(campaign.CampaignError, match=words):
        tuned(tmp_path)
    assert len(results(tmp_path)) == 3  # results of other kernels are not kept
    result, _ = tuned(tmp_path / "mixed", mixed=True)
    assert result.kernels == f"{len(results(tmp_path / 'mixed')) - 3} with AVX-512, 3 with AVX2"
    assert f"The runs used different kernels, whose results differ in their last digits: {result.kernels}." in (
        tmp_path / "mixed" / "out" / "tuning.md").read_text()


@either
def test_mixed_kernels_after_resuming_raise(tmp_path, monkeypatch):
    monkeypatch.setattr(Made, "kernels", "AVX2")
    first, _ = tuned(tmp_path, evaluations=8)
    made = len(results(tmp_path))
    assert first.kernels == ""
    monkeypatch.setattr(Made, "kernels", "AVX-512")
    with pytest.raises(campaign.CampaignError, match="1 with AVX-512, [0-9]+ with AVX2"):
        tuned(tmp_path)
    assert len(results(tmp_path)) == made
    mixed, machine = tuned(tmp_path, mixed=True)
    assert mixed.kernels.startswith(f"{len(machine.tasks)} with AVX-512, ") and machine.tasks
    with pytest.raises(campaign.CampaignError, match="different processors"):
        tuned(tmp_path)


@pytest.mark.skipif(not has_scipy, reason="SciPy is not installed (python3-scipy)")
def test_scipy_tunes_if_nlopt_is_missing(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "nlopt", None)
    result, _ = tuned(tmp_path, evaluations=60)
    assert result.better and 6 < result.best["controller.posture_weight"] < 16
    monkeypatch.setitem(sys.modules, "scipy.optimize", None)
    with pytest.raises(campaign.CampaignError, match="neither NLopt nor SciPy is installed"):
        tuned(tmp_path / "other")


def test_confidence_intervals_use_the_t_distribution():
    for freedom, quantile in ((1, 12.706), (2, 4.303), (5, 2.571), (11, 2.201), (100, 1.984)):
        assert abs(_tune._t_quantile(freedom) - quantile) < 0.002 * quantile
    mean, half = _tune.difference([1.0, 2.0, 3.0, 4.0], [0.9, 1.8, 2.9, 3.8])
    assert abs(mean + 0.15) < 1e-12 and abs(half - 0.0919) < 0.003
    assert _tune.difference([1.0], [2.0]) == (1.0, math.inf)


@pytest.mark.parametrize("change, words", [
    ({"tune": {"posture_wieght": {"from": 1, "to": 2}}}, "key 'posture_wieght' is unknown"),
    ({"tune": {"robot": {"from": 1, "to": 2}}}, "is 'arm7'; wanted a number"),
    ({"tune": {}}, "wanted keys with their ranges"),
    ({"tune": {"force": {"from": 40, "to": 20}}}, "wanted the lower limit first"),
    ({"tune": {"force": {"from": 30, "to": 40}}}, "starts at 20; wanted a range that contains the start"),
    ({"tune": {"force": {"from": 30, "to": 40, "start": 50}}}, "starts at 50; wanted a range that contains the start"),
    ({"tune": {"force": [1, 2]}}, "wanted the keys 'from' and 'to'"),
    ({"tune": {"surface.friction": {"from": 0.0, "to": 0.9}}}, "'surface.friction' is in 'vary', and 'surface.friction' is in 'tune'"),
    ({"tune": {"surface_height": {"from": 0, "to": 1, "log": True}}}, "wanted a lower limit above 0"),
    ({"train": {"samples": {"count": 2, "seed": 5}}, "test": {"samples": {"count": 2, "seed": 5}}}, "in common"),
    ({"train": 3}, "train is 3; wanted the key 'seeds', or 'samples'"),
    ({"evaluations": 2}, "evaluations is 2"),
    ({"minimise": 3}, "wanted minimise: FIGURE"),
    ({"minimize": "x"}, "did you mean 'minimise'?"),
    ({"minimise": "force_rms"}, "did you mean 'force_rmse"),
    ({"minimise": {"force_rms": 1}}, "did you mean 'force_rmse"),
    ({"minimise": {"force_rmse": 0}}, "minimise.force_rmse is 0; wanted a weight above 0"),
    ({"not_worse": ["slop"]}, "there is no figure 'slop'"),
])
def test_invalid_input_raises_one_sentence(tmp_path, change, words):
    with pytest.raises(campaign.CampaignError) as error:
        tuned(tmp_path, **change)
    assert words in str(error.value) and "\n" not in str(error.value)


def test_polishing_tuning_checks_seeds_and_keys(tmp_path):
    tree = {"task": str(TASKS / "polishing" / "board.yaml"), "minimise": "force_rmse",
            "tune": {"controller.contact_kd": {"from": 5, "to": 80}},
            "train": {"seeds": {"first": 0, "count": 2}}, "test": {"seeds": {"first": 100, "count": 3}}}
    read = _tune.read_tuning(tree)
    assert read.keys[0].start == 40.0  # the default, because board.yaml does not state it
    assert [point["disturbances.seed"] for point in read.test] == [100, 101, 102]
    for change, words in (({"tune": {"controller.contact_dk": {"from": 5, "to": 80}}}, "did you mean 'contact_kd'?"),
                          ({"test": {"seeds": [5, 1]}}, "{'disturbances.seed': 1} in common")):
        with pytest.raises(campaign.CampaignError) as error:
            _tune.read_tuning({**tree, **change})
        assert words in str(error.value)


def test_command_line_refuses_in_one_sentence(tmp_path):
    (tmp_path / "t.yaml").write_text(json.dumps({**plan(), "evaluations": 1}))
    done = subprocess.run([sys.executable, "-m", "burnish.campaign", "tune", "t.yaml"], cwd=tmp_path,
                          capture_output=True, text=True)
    assert done.returncode == 2 and done.stderr.count("\n") == 1 and "evaluations is 1" in done.stderr
