"""Sweeps: their points, runs, tables, pages and worst runs; shards; invalid input."""

from __future__ import annotations

import csv
import importlib.util
import json
import os
import shlex
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import burnish
from burnish import _core, campaign
from burnish.campaign._points import read_values
from burnish.campaign._sweep import figure_named, read_sweep
from burnish.campaign._tasks import NAMED_TASKS, TaskFile, make_task_run, outcome_of

TASKS = Path(__file__).resolve().parents[2] / "tasks"
SHORT = {"phases.polish_duration": [0.4], "path.start_up": [0.2], "path.radius": [0.02],
         "controller.update_rate": [200]}

has_scipy = importlib.util.find_spec("scipy") is not None
has_h5py = importlib.util.find_spec("h5py") is not None


def _has_program():
    try:
        return bool(campaign.program())
    except campaign.CampaignError:
        return False


runs = pytest.mark.skipif(not _has_program(), reason="the program burnish is not built")


def polishing(**more):
    vary = {**SHORT, **more.pop("vary", {})}
    return {"task": str(TASKS / "polishing" / "table.yaml"), "plant": "ideal", "controller": "baseline",
            "vary": vary, **more}


def pressing(**more):
    return {"task": str(TASKS / "press_hold" / "arm7.yaml"), "plant": "ideal", **more}


def points(vary, samples=None):
    return read_values(vary, samples).points()


class TestTasks:
    @pytest.mark.parametrize("name", NAMED_TASKS)
    def test_named_task_can_be_changed_and_gives_its_figures(self, name):
        files = list((TASKS / name).glob("*.yaml"))
        assert files
        for file in files:
            task = TaskFile.read(file)
            assert "tick_rate: 500" in task.changed({"controller.tick_rate": 500.0})
            assert task.units()["controller.tick_rate"] == "Hz"
        run = {"task": name, "succeeded": True, "outcome": "done", "figures": "own", "own": {"slip_m": 0.25}}
        made = outcome_of({"run": json.dumps(run).encode(), "late": b"", "computing": b"1.0"})
        assert made.figures == {"slip_m": 0.25}

    @runs
    def test_program_lists_the_same_tasks(self, tmp_path):
        file = tmp_path / "task.yaml"
        file.write_text("task: nothing\n")
        done = subprocess.run([campaign.program(), "run", str(file)], capture_output=True, text=True)
        assert done.returncode == 2
        assert "wanted " + " or ".join(NAMED_TASKS) in done.stderr


class TestPoints:
    def test_lists_and_ranges_make_a_grid(self):
        assert points({"a": [1, "x"], "b.c": {"from": 0, "to": 1, "count": 3}}) == [
            {"a": a, "b.c": b} for a in (1, "x") for b in (0.0, 0.5, 1.0)]
        assert [p["a"] for p in points({"a": {"from": 0.1, "to": 0.5, "step": 0.2}})] == [0.1, 0.3, 0.5]
        assert np.allclose([p["a"] for p in points({"a": {"from": 1, "to": 100, "count": 3, "log": True}})],
                           [1, 10, 100])

    def test_samples_are_drawn_once_and_depend_on_their_key_alone(self):
        vary = {"a": {"uniform": [2, 4]}, "b": {"normal": [0, 1]}, "c": {"log_uniform": [1, 100]},
                "d": {"choice": ["x", "y"]}, "e": [1, 2]}
        drawn = points(vary, {"count": 400, "seed": 3})
        assert len(drawn) == 800
        assert [{**p, "e": 0} for p in drawn[:400]] == [{**p, "e": 0} for p in drawn[400:]]
        assert all(2 <= p["a"] <= 4 and 1 <= p["c"] <= 100 for p in drawn)
        assert abs(np.mean([p["b"] for p in drawn])) < 0.2
        assert {p["d"] for p in drawn} == {"x", "y"}
        # Other keys and a larger count do not change the samples of a key.
        assert [p["a"] for p in points({"a": {"uniform": [2, 4]}}, {"count": 500, "seed": 3})][:400] == [
            p["a"] for p in drawn[:400]]
        assert drawn != points(vary, {"count": 400, "seed": 4})

    @pytest.mark.skipif(not has_scipy, reason="SciPy is not installed (python3-scipy)")
    def test_sobol_points_fill_the_square_evenly(self):
        vary = {"a": {"uniform": [0, 1]}, "b": {"uniform": [0, 1]}}
        drawn = points(vary, {"count": 64, "sobol": True})
        assert sorted(int(8 * p["a"]) * 8 + int(8 * p["b"]) for p in drawn) == list(range(64))
        assert points(vary, {"count": 5, "sobol": True}) == drawn[:5]

    @pytest.mark.parametrize("vary, samples, words", [
        ({"a": {"from": 3, "to": 1, "count": 2}}, None, "vary.a goes from 3 to 1; wanted the lower limit first"),
        ({"a": {"from": 1, "to": 3, "count": 2, "step": 1}}, None, "one of 'count' and 'step'"),
        ({"a": {"from": 1, "to": 3, "step": 5}}, None, "vary.a.step is 5; wanted"),
        ({"a": {"from": 0, "to": 3, "count": 3, "log": True}}, None, "wanted a lower limit above 0"),
        ({"a": {"from": 0, "to": 3, "cuont": 3}}, None, "did you mean 'count'?"),
        ({"a": {"from": 0, "to": "x", "count": 3}}, None, "'x'; wanted a number"),
        ({"a": []}, None, "empty list"),
        ({"a": 3}, None, "wanted a list, a range"),
        ({"a": {"unifrom": [0, 1]}}, 3, "did you mean 'uniform'?"),
        ({"a": {"uniform": [1, 0]}}, 3, "wanted the lower limit first"),
        ({"a": {"normal": [1, 0]}}, 3, "standard deviation of 0"),
        ({"a": {"log_uniform": [0, 1]}}, 3, "wanted a lower limit above 0"),
        ({"a": {"uniform": [0, 1]}}, None, "'a' has a distribution, and key 'samples' is missing"),
        ({"a": [1]}, 3, "'samples' is given, and no key has a distribution"),
        ({"a": {"uniform": [0, 1]}}, 0, "at least 1"),
        ({"a": {"uniform": [0, 1]}}, {"conut": 1}, "did you mean 'count'?"),
        ({"path": [1], "path.radius": [2]}, None, "'path' and 'path.radius', which is a part of 'path'"),
        ({"a": list(range(1000)), "b": list(range(1000))}, None, "1000000 points; wanted at most"),
        ([1], None, "wanted keys of the task"),
    ])
    def test_contradictory_points_raise_one_sentence(self, vary, samples, words):
        with pytest.raises(campaign.CampaignError) as error:
            points(vary, samples)
        assert words in str(error.value)


class TestRefusals:
    def refused(self, tree):
        with pytest.raises(campaign.CampaignError) as error:
            plan = read_sweep(tree)
            for point in plan.points():
                plan.task.changed(point)
        return str(error.value)

    def test_invalid_campaign_raises_with_the_reason(self, tmp_path):
        assert "did you mean 'vary'?" in self.refused(polishing(vray={}))
        assert "names no task" in self.refused({})
        assert "nowhere.yaml: the file cannot be opened" in self.refused({"task": "nowhere.yaml"})
        assert "did you mean 'force'?" in self.refused(polishing(vary={"forse": [1]}))
        assert "did you mean 'surface_friction'?" in self.refused(
            polishing(vary={"disturbances.surface_fricton": {"uniform": [0, 1]}}, samples=2))
        assert "'controller' is 'mcp'" in self.refused(polishing(controller="mcp"))
        assert "wanted mujoco or ideal" in self.refused(polishing(plant="gazebo"))
        assert "has only one controller; wanted no such key" in self.refused(pressing(controller="mpc"))
        assert "did you mean 'hold_duration'?" in self.refused(pressing(vary={"phases.hold_duraton": [1]}))
        assert "'vary' has 'disturbances.seed' too" in self.refused(
            polishing(seeds=3, vary={"disturbances.seed": [1]}))
        assert "wanted the keys 'figure', 'above' and 'runs'" in self.refused(polishing(stop=3))
        bad = tmp_path / "bad.yaml"
        bad.write_text("task: [")
        assert "is not valid YAML" in self.refused(bad)
        bad.write_bytes(b"task: caf\xe9.yaml\n")
        assert "not UTF-8" in self.refused(bad)
        bad.write_text("task: " + "1" * 300)
        assert "names no task" in self.refused(bad)
        for value in (np.linspace(10.0, 20.0, 3), [float("inf")]):
            assert "vary: " in self.refused(polishing(vary={"force": value}))
        assert "the file cannot be opened" in self.refused(tmp_path / "nowhere.yaml")

    def test_command_line_prints_one_sentence(self, tmp_path):
        (tmp_path / "c.yaml").write_text("task: nowhere.yaml\n")
        done = subprocess.run([sys.executable, "-m", "burnish.campaign", "sweep", "c.yaml"], cwd=tmp_path,
                              capture_output=True, text=True)
        assert (done.returncode, done.stdout) == (2, "")
        assert done.stderr == "burnish: nowhere.yaml: the file cannot be opened; wanted a readable YAML file\n"
        assert sorted(os.listdir(tmp_path)) == ["c.yaml"]


def table(folder):
    with open(Path(folder) / "results.csv", newline="") as file:
        return list(csv.DictReader(file))


@runs
class TestRuns:
    @pytest.fixture(scope="class")
    def made(self, tmp_path_factory):
        out = tmp_path_factory.mktemp("sweep") / "out"
        plan = polishing(vary={"disturbances.surface_friction": {"uniform": [0, 0.4]}}, samples=2,
                         seeds=[4, 5], keep=["force_rmse", "position_rmse_m"],
                         worst={"figure": "force_rmse", "count": 1})
        return out, campaign.sweep(plan, out=out, quiet=True, threads=2)

    def test_table_has_every_run_with_units(self, made):
        out, result = made
        rows = table(out)
        assert len(rows) == len(result.rows) == 4
        assert [row["disturbances.seed"] for row in rows] == ["4", "5", "4", "5"]
        assert all(float(row["force_rmse [N]"]) > 0 for row in rows)
        assert "phases.polish_duration [s]" in rows[0] and "disturbances.surface_friction" in rows[0]
        assert "position_rmse [m]" in rows[0] and not any("force_peak" in key for key in rows[0])
        # A run of the library gives the same figures.
        run = burnish.polishing.run(_written(out, result.rows[1]), controller="baseline", plant="ideal")
        assert float(rows[1]["force_rmse [N]"]) == run.metrics.force_rmse

    @pytest.mark.skipif(not has_h5py, reason="h5py is not installed (python3-h5py)")
    def test_hdf5_matches_the_table_and_has_the_campaign_text(self, made):
        import h5py

        out, result = made
        with h5py.File(out / "results.h5") as book:
            assert book.attrs["campaign"] == result.sweep.text
            assert book["force_rmse"].attrs["unit"] == "N"
            assert list(book["force_rmse"]) == [float(row["force_rmse [N]"]) for row in table(out)]
            assert book["outcome"].asstr()[0] == table(out)[0]["outcome"]

    def test_worst_run_has_a_record_and_a_command_that_repeats_it(self, made):
        out, result = made
        worst = result.worst()[0]
        assert worst.outcome.figures["force_rmse_N"] == max(result.values("force_rmse_N"))
        record = out / "worst" / f"run_{worst.number}" / "run"
        page = (out / "results.html").read_text()
        assert "<h2>Distributions</h2>" in page and page.count("<svg") >= 3
        command = next(line for line in page.replace("</pre>", "\n").replace("<pre>", "\n").splitlines()
                       if line.startswith("burnish polish worst/"))
        first = json.loads(next(record.rglob("metrics.json")).read_text())["metrics"]
        words = [campaign.program(), *shlex.split(command)[1:], "--quiet", "--force"]
        assert subprocess.run(words, cwd=out, capture_output=True).returncode in (0, 1)
        again = json.loads(next(record.rglob("metrics.json")).read_text())["metrics"]
        for figure in ("force_rmse_N", "position_rmse_m"):
            assert again[figure] == first[figure] == worst.outcome.figures[figure]

    def test_resume_does_not_repeat_finished_runs(self, made):
        out, result = made
        before = {file: file.stat().st_mtime_ns for file in (out / "runs").iterdir()}
        text = (out / "results.csv").read_text()
        again = campaign.sweep(json.loads(json.dumps(_tree(result))), out=out, quiet=True, resume=True)
        assert [row.outcome.figures for row in again.rows] == [row.outcome.figures for row in result.rows]
        assert {file: file.stat().st_mtime_ns for file in (out / "runs").iterdir()} == before
        assert (out / "results.csv").read_text() == text
        with pytest.raises(campaign.CampaignError, match="holds a run; wanted another folder"):
            campaign.sweep(_tree(result), out=out, quiet=True)

    def test_press_hold_sweep_stops_early_and_reports_refused_runs(self, tmp_path):
        plan = pressing(vary={"phases.hold_duration": [0.1], "phases.touch_force": [25, 5, 5.5, 6]},
                        stop={"figure": "force_rmse", "above": 0.0, "runs": 2})
        result = campaign.sweep(plan, out=tmp_path / "out", quiet=True, threads=2)
        assert [row.outcome.succeeded for row in result.rows] == [False, True, True]
        assert "phases.touch_force: it is 25 N, more than the force of 20 N" in result.rows[0].outcome.outcome
        assert result.stopped == "ended after 3 of 4 runs: 2 had force_rmse above 0"
        rows = table(tmp_path / "out")
        assert [row["succeeded"] for row in rows] == ["no", "yes", "yes"]
        assert rows[0]["force_rmse [N]"] == "" and float(rows[2]["slip [m]"]) > 0

    def test_press_hold_sweep_varies_seeds(self, tmp_path):
        plan = pressing(vary={"phases.hold_duration": [0.1], "disturbances.force_noise": [0.3]}, seeds=2)
        rows = campaign.sweep(plan, out=tmp_path / "out", quiet=True, threads=2).rows
        assert [row.point["disturbances.seed"] for row in rows] == [0, 1]
        assert all(row.outcome.succeeded for row in rows)
        assert rows[0].outcome.figures["force_rmse_N"] != rows[1].outcome.figures["force_rmse_N"]

    def test_seeds_vary_disturbances_given_as_a_preset(self, tmp_path):
        task = tmp_path / "mine.yaml"
        task.write_text("task: press_hold\nrobot: arm7\ndisturbances: sensors\nphases: {hold_duration: 0.1}\n")
        rows = campaign.sweep({"task": str(task), "plant": "ideal", "seeds": [3, 4]}, out=tmp_path / "out", quiet=True).rows
        first, second = (row.outcome.figures["force_rmse_N"] for row in rows)
        assert first != second

    def test_unknown_figure_raises_with_the_nearest(self, tmp_path):
        assert [figure_named(name, ["slip_m"]) for name in ("hold.slip", "slip", "slip_m")] == ["slip_m"] * 3
        with pytest.raises(campaign.CampaignError, match="there is no figure 'force_rms'; did you mean 'force_rmse"):
            campaign.sweep(pressing(vary={"phases.hold_duration": [0.1]}, keep=["force_rms"]), out=tmp_path / "out",
                           quiet=True)

    def test_run_beyond_its_time_limit_is_ended_and_reported(self):
        text = (TASKS / "press_hold" / "arm7.yaml").read_text()
        words = [campaign.program(), ["run", "--plant", "ideal"], text, ".", 0.01]
        with pytest.raises(TypeError, match="'name'"):
            make_task_run(*words)  # without a name, nothing could find the result
        outcome = outcome_of(make_task_run(*words, "late")["late"])
        assert (outcome.late, outcome.succeeded, outcome.outcome) == (True, False, "ended by its time limit")
        assert not outcome.figures


@runs
class TestShards:
    PLAN = dict(vary={"phases.hold_duration": [0.1], "phases.aside_duration": [1.2],
                      "phases.ramp_duration": [0.2], "surface.friction": {"from": 0.1, "to": 0.5, "count": 5}},
                worst={"figure": "slip", "count": 1})

    @pytest.fixture
    def file(self, tmp_path):
        file = tmp_path / "friction.yaml"
        file.write_text("".join(f"{key}: {json.dumps(value)}\n" for key, value in pressing(**self.PLAN).items()))
        return file

    def test_merge_gives_the_files_of_one_process(self, tmp_path, file, capsys):
        one, parts = tmp_path / "one", [tmp_path / f"part_{i}" for i in (1, 2)]
        campaign.sweep(file, out=one, quiet=True)
        for i, part in enumerate(parts):
            result = campaign.sweep(file, out=part, shard=f"{i + 1}/2", threads=1)
            assert [row.number for row in result.rows] == ([1, 3, 5], [2, 4])[i]
            assert not (part / "results.csv").exists()
        assert "friction, shard 2/2: 2 runs, 0 of them did not succeed" in capsys.readouterr().out
        before = {each: each.stat().st_mtime_ns for each in (parts[0] / "runs").iterdir()}
        campaign.sweep(file, out=parts[0], shard="1/2", resume=True, quiet=True)
        assert {each: each.stat().st_mtime_ns for each in (parts[0] / "runs").iterdir()} == before
        merged = tmp_path / "merged"
        words = [campaign.program(), "merge", *map(str, parts), "--out", str(merged)]
        done = subprocess.run(words, capture_output=True, text=True)
        assert (done.returncode, done.stderr) == (0, "")
        assert "5 runs, 0 of them did not succeed" in done.stdout
        for name in ("results.csv", "results.html", "campaign.yaml", "campaign.json"):
            assert (merged / name).read_bytes() == (one / name).read_bytes()
        assert (merged / "results.h5").exists() == (one / "results.h5").exists()
        assert (merged / "worst").is_dir()
        # The tables may be written into the folder of the runs.
        assert campaign.merge(parts, out=parts[0], quiet=True).rows[4].number == 5
        assert (parts[0] / "results.csv").read_bytes() == (one / "results.csv").read_bytes()

    def test_several_shards_in_one_folder_merge_to_the_same_files(self, tmp_path, file, monkeypatch):
        monkeypatch.chdir(tmp_path)
        campaign.sweep(file, out="one", quiet=True)
        result = campaign.sweep(file, shard="3,1/3", threads=1, quiet=True)
        some = Path("friction_campaign_1_3_of_3")
        assert [row.number for row in result.rows] == [1, 3, 4]
        assert json.loads((some / "campaign.json").read_text())["shard"] == "3,1/3"
        lacking = r"2 of 5 runs are missing, .* \(without a folder: 2/3\)"
        with pytest.raises(campaign.CampaignError, match=lacking):
            campaign.merge([some], out="no", quiet=True)
        words = ["sweep", str(file), "--shard", "2/3", "--out", "other", "--quiet"]
        done = subprocess.run([sys.executable, "-m", "burnish.campaign", *words])
        assert done.returncode == 0
        campaign.merge([some, "other"], out="merged", quiet=True)
        for name in ("results.csv", "results.html", "campaign.yaml", "campaign.json"):
            assert Path("merged", name).read_bytes() == Path("one", name).read_bytes()
        # A folder resumes with more shards; all shards give the whole campaign.
        campaign.sweep(file, out=some, shard="1,2,3/3", resume=True, threads=1, quiet=True)
        campaign.merge([some], out="all", quiet=True)
        assert Path("all", "results.csv").read_bytes() == Path("one", "results.csv").read_bytes()

    def test_incompatible_folders_and_shards_raise_one_sentence(self, tmp_path, file):
        part = tmp_path / "part"
        campaign.sweep(file, out=part, shard="2/3", quiet=True)

        def refused(*folders):
            with pytest.raises(campaign.CampaignError) as error:
                campaign.merge(folders, out=tmp_path / "no", quiet=True)
            assert not (tmp_path / "no").exists()
            return str(error.value)

        assert refused(part) == ("3 of 5 runs are missing, first number 1; wanted all shards, each with "
                                 "all of its runs (without a folder: 1/3, 3/3)")
        assert "no folder is named" in refused()
        assert f"'{tmp_path}' holds no runs of a campaign" in refused(part, tmp_path)
        for key, value, words in (("campaign", "task: x\n", "holds runs of another campaign than"),
                                  ("task", "force: 3\n", "holds runs of another task than"),
                                  ("version", "0.0.1", "holds runs of burnish 0.0.1, but this is burnish"),
                                  ("experiment", "seeds", "wanted runs of burnish sweep")):
            other = tmp_path / f"other_{key}"
            other.mkdir()
            tree = json.loads((part / "campaign.json").read_text())
            (other / "campaign.json").write_text(json.dumps({**tree, key: value}))
            assert words in refused(part, other)
        for shard in ("0/2", "3/2", "2", "a/b", "1/2/3", "", "1,3/2", "0,1/2", "1,/2", ",1/2",
                      "1,2", "1,2/", "/2", "-1/2"):
            with pytest.raises(campaign.CampaignError,
                               match="wanted I/N with I from 1 to N, .* or several shards, such as 1,3/4"):
                campaign.sweep(file, out=tmp_path / "no", shard=shard, quiet=True)
        there = subprocess.run([campaign.program(), "experiment", "seeds", "--quick", "--resume", "--out", str(part)],
                               capture_output=True, text=True)
        assert (there.returncode, "holds runs of burnish sweep" in there.stderr) == (2, True)

    def test_mixed_kernels_are_refused_or_reported(self, tmp_path, file):
        parts = [tmp_path / f"part_{i}" for i in (1, 2)]
        for i, part in enumerate(parts):
            campaign.sweep(file, out=part, shard=f"{i + 1}/2", quiet=True)
        for times in (parts[1] / "runs").glob("*.times.json"):
            times.write_text(json.dumps({**json.loads(times.read_text()), "kernels": "ABACUS"}))
        own = json.loads(next((parts[0] / "runs").glob("*.times.json")).read_text())["kernels"]
        words = f"2 with ABACUS, 3 with {own}"
        with pytest.raises(campaign.CampaignError, match=f"different processors .{words}."):
            campaign.merge(parts, out=tmp_path / "no", quiet=True)
        with pytest.raises(campaign.CampaignError, match="different processors"):
            campaign.sweep(file, out=parts[1], resume=True, quiet=True)
        campaign.merge(parts, out=tmp_path / "mixed", mixed=True, quiet=True)
        assert words in (tmp_path / "mixed" / "results.html").read_text()
        assert [row["kernels"] for row in table(tmp_path / "mixed")] == [own, "ABACUS", own, "ABACUS", own]

    def test_shards_that_stop_early_merge_to_the_whole(self, tmp_path, file):
        file.write_text(file.read_text() + "stop: {figure: force_rmse, above: 0, runs: 2}\n")
        parts = [tmp_path / f"part_{i}" for i in (1, 2)]
        rows = [campaign.sweep(file, out=part, shard=f"{i + 1}/2", threads=1, quiet=True).rows
                for i, part in enumerate(parts)]
        assert [[row.number for row in each] for each in rows] == [[1, 3], [2, 4]]
        merged = campaign.merge(parts, out=tmp_path / "merged", quiet=True)
        assert [row.number for row in merged.rows] == [1, 2]
        assert merged.stopped == "ended after 2 of 5 runs: 2 had force_rmse above 0"


def _written(out, row):
    path = out / "task.yaml"
    path.write_text(row.run.text)
    return path


def _tree(result):
    return _core.parse_yaml(result.sweep.text)
