"""Experiments on the workers of a Dask scheduler: the files equal those of one process, also after
failures. Tests that start and kill processes run with ./test --long."""

from __future__ import annotations

import importlib.util
import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import threading
import time
from pathlib import Path

import pytest

from burnish import campaign
from burnish.campaign._results import RunFolder

QUICK = ["seeds", "--quick", "--plant", "ideal", "--seeds"]


def _has_program():
    try:
        return bool(campaign.program())
    except campaign.CampaignError:
        return False


has_dask = importlib.util.find_spec("distributed") is not None
pytestmark = pytest.mark.skipif(not _has_program(), reason="the program burnish is not built")
with_dask = pytest.mark.skipif(not has_dask, reason="Dask distributed is not installed (python3-distributed)")
long = pytest.mark.skipif("BURNISH_TEST_LONG" not in os.environ, reason="takes long: ./test --long")


def burnish(*words):
    return subprocess.run([campaign.program(), *map(str, words)], capture_output=True, text=True)


def files(folder, ignored=("campaign.json", ".burnish")):
    return {str(file.relative_to(folder)): file.read_bytes() for file in Path(folder).rglob("*")
            if file.is_file() and file.name not in ignored and not file.name.endswith(".times.json")}


def refused(words, **options):
    with pytest.raises(campaign.CampaignError) as error:
        campaign.experiment(words, quiet=True, **options)
    return str(error.value)


@pytest.fixture(scope="module")
def one_process(tmp_path_factory):
    out = tmp_path_factory.mktemp("one") / "out"
    assert burnish("experiment", *QUICK, 4, "--quiet", "--out", out).returncode == 0
    return files(out)


class TestLocal:
    def test_run_without_scheduler_gives_the_files_of_one_process(self, tmp_path, one_process):
        folder = campaign.experiment([*QUICK, "4"], out=tmp_path / "out", quiet=True)
        assert files(folder) == one_process

    def test_invalid_arguments_raise_one_sentence(self, tmp_path, monkeypatch):
        monkeypatch.chdir(tmp_path)
        assert "--resume requires --out" in refused([*QUICK, "1"], resume=True)
        assert "no experiment is named" in refused([])
        (tmp_path / "held" / "runs").mkdir(parents=True)
        assert "holds a run; wanted another folder, or --resume" in refused([*QUICK, "1"], out="held")
        with RunFolder(tmp_path / "new", "", False):
            assert "another run writes into" in refused([*QUICK, "1"], out="new")
        assert not (tmp_path / "new").exists()

    def test_run_folder_keeps_complete_results_only(self, tmp_path):
        with RunFolder(tmp_path / "out", "", False) as folder:
            assert not folder.has("a")
            kept = {"campaign": b'{"shard": "1/2"}', "times": b'{"computing": 2.5}', "result": b'{"late": false}'}
            assert folder.keep("a", kept) == 2.5
            assert folder.has("a")
            assert json.loads((folder.path / "campaign.json").read_text())["shard"] == ""
            assert folder.keep("b", {**kept, "result": b'{"late": true}'}) is None
            assert not folder.has("b")  # a run that was ended is tried again
            (folder.path / "runs" / "a.json").write_text("{")
            with pytest.raises(campaign.CampaignError, match="is not the result of a run"):
                folder.has("a")
            shutil.rmtree(folder.path / "runs")
            (folder.path / "runs").symlink_to("/dev/full")
            with pytest.raises(campaign.CampaignError, match="cannot"):
                folder.keep("a", kept)

    def test_missing_dask_names_the_package_to_install(self, tmp_path):
        (tmp_path / "distributed.py").write_text("raise ImportError")
        done = subprocess.run([campaign.program(), "experiment", *QUICK, "1", "--scheduler", "tcp://127.0.0.1:1"],
                              capture_output=True, text=True, cwd=tmp_path,
                              env={**os.environ, "PYTHONPATH": f"{tmp_path}:{os.environ['PYTHONPATH']}"})
        assert done.returncode == 2
        # The package of the build precedes others on the path.
        assert "apt install python3-distributed" in done.stderr or "apt install python3-burnish" in done.stderr
        assert done.stderr.count("\n") == 1


@with_dask
class TestDask:
    def test_unreachable_scheduler_raises_one_sentence(self, tmp_path):
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            address = f"tcp://127.0.0.1:{free.getsockname()[1]}"
        out = tmp_path / "out"
        assert f"there is no Dask scheduler at '{address}'" in refused([*QUICK, "1"], scheduler=address, out=out)
        assert not out.exists()
        for address in ("nowhere", "tcp://host", "tcp://host:port", ":1"):
            assert f"'{address}' is not the address" in refused([*QUICK, "1"], scheduler=address, out=out)
        assert "did you mean 'seeds'?" in refused(["seed"], scheduler="tcp://127.0.0.1:1")


def _wait(condition, seconds=60.0):
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "the condition did not come true in time"
        time.sleep(0.02)


class Cluster:
    """Scheduler and workers, each a process group that can be killed; killed workers restart."""

    def __init__(self, folder):
        self._folder, self._processes = folder, []
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        self.address = f"tcp://127.0.0.1:{self.port}"
        self.scheduler = None
        self.start_scheduler()

    def _start(self, words, forever=False):
        command = [sys.executable, "-m", *words, "--no-dashboard"]
        if forever:
            command = ["sh", "-c", 'while :; do "$@"; sleep 0.2; done', "sh", *command]
        environment = {**os.environ, "DASK_DISTRIBUTED__SCHEDULER__WORKER_TTL": "4s",
                       "DASK_DISTRIBUTED__COMM__TIMEOUTS__CONNECT": "5s",
                       "DASK_DISTRIBUTED__DEPLOY__LOST_WORKER_TIMEOUT": "2s"}
        log = open(self._folder / f"log_{len(self._processes)}", "w")
        process = subprocess.Popen(command, stdout=log, stderr=log, env=environment, start_new_session=True)
        self._processes.append(process)
        return process

    def start_scheduler(self):
        self.scheduler = self._start(["distributed.cli.dask_scheduler", "--host", "127.0.0.1",
                                      "--port", str(self.port)])

        def answers():
            with socket.socket() as one:
                return one.connect_ex(("127.0.0.1", self.port)) == 0

        _wait(answers)

    def start_worker(self):
        return self._start(["distributed.cli.dask_worker", self.address, "--nthreads", "1", "--nworkers", "1",
                            "--local-directory", str(self._folder)], forever=True)

    @staticmethod
    def send(process, number):
        os.killpg(process.pid, number)

    def close(self):
        for process in self._processes:
            for number in (signal.SIGCONT, signal.SIGKILL):
                try:
                    os.killpg(process.pid, number)
                except ProcessLookupError:
                    pass
            process.wait()


@pytest.fixture
def processes(tmp_path):
    cluster = Cluster(tmp_path)
    yield cluster
    cluster.close()


def _results(out):
    return len([file for file in Path(out).glob("runs/*.json") if not file.name.endswith(".times.json")])


@with_dask
class TestProcesses:
    def test_workers_give_the_files_of_one_process(self, processes, tmp_path, one_process):
        processes.start_worker()
        processes.start_worker()
        out = tmp_path / "out"
        done = burnish("experiment", *QUICK, 4, "--scheduler", processes.address, "--out", out, "--quiet")
        assert (done.returncode, done.stderr) == (0, "")
        assert files(out) == one_process
        # A complete run resumes without work for the workers.
        assert burnish("experiment", *QUICK, 4, "--scheduler", processes.address, "--out", out, "--quiet",
                       "--resume").returncode == 0
        assert files(out) == one_process
        refusal = burnish("experiment", *QUICK, 4, "--set", "force=20", "--scheduler", processes.address,
                          "--out", out, "--resume")
        assert "wanted these options" in refusal.stderr

    @long
    def test_killed_workers_and_scheduler_lose_nothing(self, processes, tmp_path):
        words = [*QUICK, "60"]
        one, out = tmp_path / "one", tmp_path / "out"
        assert burnish("experiment", *words, "--quiet", "--out", one).returncode == 0
        killed, stopped, slow = (processes.start_worker() for _ in range(3))
        job = subprocess.Popen([campaign.program(), "experiment", *words, "--scheduler", processes.address,
                                "--out", str(out), "--quiet"], stderr=subprocess.PIPE, text=True)

        def reach(count):
            _wait(lambda: _results(out) >= count or job.poll() is not None, 120.0)
            assert job.poll() is None, job.stderr.read()

        ends = threading.Event()

        def hamper():
            while not ends.is_set():
                processes.send(slow, signal.SIGSTOP)
                time.sleep(0.3)
                processes.send(slow, signal.SIGCONT)
                time.sleep(0.1)

        reach(3)
        hampering = threading.Thread(target=hamper)
        hampering.start()
        try:
            reach(8)
            processes.send(killed, signal.SIGKILL)
            reach(14)
            processes.send(stopped, signal.SIGSTOP)
            processes.start_worker()
            reach(25)
            processes.send(processes.scheduler, signal.SIGKILL)
            processes.scheduler.wait()
            time.sleep(2.0)
            processes.start_scheduler()
            errors = job.communicate(timeout=400)[1]
        finally:
            ends.set()
            hampering.join()
            job.kill()
        assert job.returncode == 0, errors
        assert files(out) == files(one)

    @long
    def test_sweep_on_workers_gives_the_local_files(self, processes, tmp_path):
        processes.start_worker()
        processes.start_worker()
        task = Path(__file__).resolve().parents[2] / "tasks" / "press_hold" / "arm7.yaml"
        plan = {"task": str(task), "plant": "ideal",
                "vary": {"phases.hold_duration": [0.1], "surface.friction": {"from": 0.1, "to": 0.3, "count": 5}}}
        campaign.sweep(plan, out=tmp_path / "here", quiet=True)
        campaign.sweep(plan, out=tmp_path / "there", quiet=True, scheduler=processes.address)
        ignored = ("results.h5", "results.html")
        assert files(tmp_path / "here", ignored) == files(tmp_path / "there", ignored)

    @long
    def test_interrupted_ten_times_resumes_without_repeating_runs(self, processes, tmp_path):
        words = [*QUICK, "44"]
        one, out = tmp_path / "one", tmp_path / "out"
        assert burnish("experiment", *words, "--quiet", "--out", one).returncode == 0
        processes.start_worker()
        processes.start_worker()
        command = [campaign.program(), "experiment", *words, "--scheduler", processes.address, "--out", str(out),
                   "--resume", "--quiet"]
        made = {}
        for interruption in range(10):
            job = subprocess.Popen(command, stderr=subprocess.PIPE)
            _wait(lambda: _results(out) >= 3 * (interruption + 1) or job.poll() is not None, 120.0)
            assert job.poll() is None, job.stderr.read()
            job.send_signal(signal.SIGKILL if interruption % 2 else signal.SIGINT)
            job.wait()
            for file in Path(out).glob("runs/*.json"):
                assert made.setdefault(file, file.stat().st_mtime_ns) == file.stat().st_mtime_ns, "made twice"
        assert subprocess.run(command).returncode == 0
        assert files(out) == files(one)
        assert not list(Path(out).rglob("*.part"))
