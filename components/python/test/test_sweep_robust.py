"""Sweeps that are stopped, killed, or have no room: finished rows stay, and everything else is reported."""

import json
import os
import signal
import subprocess
import sys
import threading

import pytest
from sweeps import BALL, PACKAGES, WORLD, children, command, make, start, wait_for, write

from pongsim import sweep
from pongsim.sweep import runner
from pongsim.sweep.journal import Journal
from pongsim.sweep.local_pool import LocalPool

#: A measure that reports that it is running, and waits until it is released or killed.
WAITS = """
import os, pathlib, time
HERE = pathlib.Path(__file__).parent
def waits(sim, parameters):
    name = parameters["name"]
    if name in (HERE / "wait").read_text().split():
        made = HERE / f"new.{name}"
        made.write_text(str(os.getpid()))
        made.rename(HERE / f"pid.{name}")
        while name in (HERE / "wait").read_text().split():
            time.sleep(0.01)
    return name
"""


def waiting(folder, names, wait):
    """A sweep over this many names, some of which wait."""
    write(folder, "w.sdf", WORLD)
    write(folder, "judge.py", WAITS)
    write(folder, "wait", " ".join(wait))
    made = {"world": "w.sdf", "duration": 0.01, "parameters": {"name": {"values": names}},
            "measures": {"m": {"function": "judge.py:waits"}}}
    return write(folder, "s.yaml", json.dumps(made))


def pid(folder, name):
    return int((folder / f"pid.{name}").read_text())


def test_twenty_killed_processes_cost_their_runs_only(tmp_path):
    names = [f"n{i}" for i in range(60)]
    killed = names[::3]
    file = waiting(tmp_path, names, killed)
    process = start(tmp_path, file, "--jobs", "3")
    left = set(killed)

    def wait():
        return [name for name in left if (tmp_path / f"pid.{name}").exists()]

    # in any order: a run may wait its turn behind one that was started after it
    while left:
        wait_for(wait, process)
        for name in wait():
            os.kill(pid(tmp_path, name), signal.SIGKILL)
            left.remove(name)
    out, err = process.communicate(timeout=300)
    assert process.returncode == 1, err
    assert "60 runs, 40 done, 20 failed" in out
    assert err.count("its process was killed by SIGKILL") == 10 and "... and 10 more" in err
    # those that were killed are repeated, and no others
    write(tmp_path, "wait", "")
    before = {each: json.loads(each) for each in (tmp_path / "s.sweep/journal.jsonl").read_text().splitlines()}
    assert command(tmp_path, file)[0] == 0
    lines = (tmp_path / "s.sweep/journal.jsonl").read_text().splitlines()
    assert lines[:len(before)] == list(before)
    again = [json.loads(line)["parameters"]["name"] for line in lines[len(before):]]
    assert sorted(again) == sorted(killed)


def test_ctrl_c_keeps_what_is_done_and_the_next_time_makes_the_rest(tmp_path):
    file = waiting(tmp_path, ["a", "b", "c", "d"], ["c"])
    process = start(tmp_path, file, "--jobs", "1")
    journal = tmp_path / "s.sweep/journal.jsonl"
    # the third has begun, and two are written down
    wait_for(lambda: (tmp_path / "pid.c").exists() and len(journal.read_text().splitlines()) == 3, process)
    workers = children(process.pid)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=120)
    assert process.returncode == 1 and "run the same command to continue" in err and "Traceback" not in err
    assert all(not os.path.exists(f"/proc/{each}") for each in workers)
    assert (tmp_path / "s.sweep/results.csv").read_text().count("done") == 2
    write(tmp_path, "wait", "")
    code, out, err = command(tmp_path, file)
    assert (code, err) == (0, "") and out.startswith("4 runs, 4 done, 0 failed")
    numbers = [json.loads(line).get("run") for line in journal.read_text().splitlines()]
    assert numbers[1:3] == [0, 1] and sorted(numbers[3:]) == [2, 3]


def test_ctrl_c_right_after_a_row_is_written_keeps_it_in_the_tables(tmp_path, monkeypatch):
    write_row = Journal._write

    def interrupted(journal, value):
        write_row(journal, value)
        if value.get("run") == 1:
            raise KeyboardInterrupt

    monkeypatch.setattr(Journal, "_write", interrupted)
    with pytest.raises(KeyboardInterrupt):
        make(tmp_path, options={"jobs": 1})
    folder = tmp_path / "out"
    written = len((folder / "journal.jsonl").read_text().splitlines()) - 1
    assert written == 2 and (folder / "results.csv").read_text().count("done") == written


def test_its_processes_end_with_a_sweep_that_is_killed(tmp_path):
    file = waiting(tmp_path, ["a", "b"], ["b"])
    process = start(tmp_path, file, "--jobs", "2")
    wait_for((tmp_path / "pid.b").exists, process)
    workers = children(process.pid)
    process.kill()
    process.communicate()
    wait_for(lambda: not any(os.path.exists(f"/proc/{each}") for each in workers))


def test_a_line_that_a_crash_tore_is_made_again(tmp_path):
    first = make(tmp_path)
    journal = first.folder / "journal.jsonl"
    journal.write_bytes(journal.read_bytes()[:-20])
    again = make(tmp_path)
    assert again.column("state_hash") == first.column("state_hash")
    assert len(journal.read_text().splitlines()) == 3


def test_a_changed_sweep_is_refused_until_told(tmp_path):
    make(tmp_path)
    with pytest.raises(sweep.SweepError, match=r"made with a different version of the sweep \(use --restart to discard them"):
        make(tmp_path, duration=0.1)
    assert make(tmp_path, duration=0.1, options={"restart": True}).column("sim_time") == [0.1, 0.1]
    write(tmp_path, "w.sdf", WORLD.replace("<mass>2", "<mass>3"))
    with pytest.raises(sweep.SweepError, match=r"made with a different version of \S*w.sdf \("):
        make(tmp_path, duration=0.1)


@pytest.mark.parametrize("text, message", [("{}\n", "not a journal of a sweep"), ("\x00\xff\n", "not a journal of a sweep"),
                                           (None, "journal.jsonl:2: error: this is not a row of a sweep")])
def test_a_journal_that_is_none_is_refused(tmp_path, text, message):
    journal = make(tmp_path).folder / "journal.jsonl"
    lines = journal.read_text().splitlines(keepends=True)
    journal.write_text(text if text is not None else lines[0] + '{"run": 0, "what": 1}\n')
    with pytest.raises(sweep.SweepError, match=message):
        make(tmp_path)


def test_two_sweeps_in_one_folder_are_refused(tmp_path):
    file = waiting(tmp_path, ["a"], ["a"])
    process = start(tmp_path, file)
    wait_for((tmp_path / "pid.a").exists, process)
    code, _, err = command(tmp_path, file)
    write(tmp_path, "wait", "")
    assert code == 1 and "another pongsim sweep is running there" in err
    assert process.wait(120) == 0


def test_a_full_disk_fails_the_runs_that_find_no_room(tmp_path):
    """With a limit on file sizes, which fails like a full disk."""
    seeds = 40
    code = f"""
import resource, sys
sys.path.insert(0, {os.path.dirname(__file__)!r})
from sweeps import make
resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))
results = make({str(tmp_path)!r}, parameters=None, seeds={seeds}, options={{"parquet": False, "jobs": 2}})
print(results.table_error, len(results), len(results.failed), results.failed[0].reason, sep="|")
"""
    process = subprocess.Popen([sys.executable, "-c", code], text=True, stderr=subprocess.PIPE, stdout=subprocess.PIPE,
                               env={**os.environ, "PYTHONPATH": PACKAGES})
    out, err = process.communicate(timeout=300)
    lines = (tmp_path / "out/journal.jsonl").read_text().splitlines()
    assert 1 < len(lines) < seeds and all(json.loads(line) for line in lines)
    # the table has no room either
    table_error, made, failed, reason = out.strip().split("|")
    assert table_error == f"{tmp_path / 'out'}: File too large" and int(made) == seeds
    assert int(failed) == seeds - (len(lines) - 1)
    assert reason == f"it can't be written to {tmp_path / 'out/journal.jsonl'}: File too large"
    assert not list((tmp_path / "out").glob(".results*")) and not (tmp_path / "out/results.csv").exists()
    results = make(tmp_path, parameters=None, seeds=seeds)
    assert len(results) == seeds and not results.failed


def test_a_row_that_can_not_be_written_counts_as_failed(tmp_path, monkeypatch):
    write_row = runner.Journal.add

    def add(journal, row):
        if row.run == 1:
            raise OSError(28, "No space left on device")
        write_row(journal, row)

    monkeypatch.setattr(runner.Journal, "add", add)
    rows = make(tmp_path, seeds=2).rows
    assert [row.status for row in rows] == ["done", "failed", "done", "done"]
    assert rows[1].reason.endswith("journal.jsonl: No space left on device")
    monkeypatch.undo()
    assert not make(tmp_path, seeds=2).failed


def test_wall_time_ends_steps_and_functions(tmp_path):
    write(tmp_path, "judge.py", "import time\ndef sleeps(sim, parameters):\n    while True: time.sleep(0.01)\n"
          "def catches(sim, parameters):\n    while True:\n        try: time.sleep(0.01)\n        except Exception: pass\n")
    for name in ("sleeps", "catches"):
        results = make(tmp_path, parameters=None, limits={"wall": 0.2}, options={"restart": True},
                       measures={"m": {"function": str(tmp_path / f"judge.py:{name}")}})
        assert results.rows[0].reason == "it took longer than 0.2 s of wall time"
    # so long that the world is loaded by then on a busy machine too
    endless = make(tmp_path, parameters=None, limits={"wall": 15}, duration=1e9, options={"restart": True})
    assert endless.rows[0].reason == "it took longer than 15 s of wall time"
    assert endless.rows[0].sim_time > 0


def test_what_can_not_be_interrupted_is_killed(tmp_path, monkeypatch):
    write(tmp_path, "judge.py", "import signal, time\ndef hangs(sim, parameters):\n"
          "    signal.signal(signal.SIGALRM, signal.SIG_IGN)\n    while parameters['name'] == 'a': time.sleep(0.01)\n    return 1\n")
    monkeypatch.setattr("pongsim.sweep.local_pool._GRACE", 0.3)
    results = make(tmp_path, parameters={"name": {"values": ["a", "b"]}}, limits={"wall": 15},
                   measures={"m": {"function": str(tmp_path / "judge.py:hangs")}})
    assert [row.reason for row in results.rows] == ["it took longer than 15 s of wall time, and was killed", ""]


def test_processes_that_do_not_start_end_the_sweep(tmp_path, monkeypatch):
    monkeypatch.setattr("pongsim.sweep.local_pool._START", "raise SystemExit(7)")
    with pytest.raises(sweep.SweepError, match="can't be started: the last one ended with code 7"):
        make(tmp_path)


def test_sweeps_on_threads_are_independent(tmp_path):
    results = {}

    def work(name):
        (tmp_path / name).mkdir()
        results[name] = make(tmp_path / name, options={"jobs": 1}).column("state_hash")

    threads = [threading.Thread(target=work, args=(name,)) for name in "ab"]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert results["a"] == results["b"] and all(results["a"])


def test_the_command(tmp_path):
    write(tmp_path, "w.sdf", WORLD)
    file = write(tmp_path, "s.yaml", json.dumps(BALL))
    assert command(tmp_path, file, "--dry-run") == (0, "run 0: height=2 seed=0\nrun 1: height=3 seed=0\n", "")
    assert not (tmp_path / "s.sweep").exists()
    code, out, err = command(tmp_path, "s.yaml", "--output", "o")
    assert (code, out) == (0, "2 runs, 2 done, 0 failed; o: results.csv and results.parquet\n"), err
    assert command(tmp_path, "world", "s.yaml", "1")[1] == WORLD.replace("0 0 2 0 0 0", "0 0 3 0 0 0")
    for arguments, expected, said in (
        ((), 2, "the following arguments are required: FILE.yaml"),
        (("s.yaml", "--jobs", "many"), 2, "argument -j/--jobs: invalid int value: 'many'"),
        (("s.yaml", "--jobs", "0"), 1, "jobs must be 1 or more, not 0"),
        (("x.yaml",), 1, "x.yaml: No such file or directory"),
        (("world", "s.yaml", "2"), 1, "there is no run 2: runs are 0 to 1"),
        (("s.yaml", "--output", "w.sdf"), 1, "w.sdf/journal.jsonl: "),
    ):
        code, out, err = command(tmp_path, *arguments)
        assert (code, out) == (expected, "") and said in err and "Traceback" not in err, (arguments, err)
    assert "examples:" in command(tmp_path, "--help")[1]


def test_there_are_no_more_processes_than_runs(tmp_path):
    write(tmp_path, "w.sdf", WORLD)
    made = sweep.read(write(tmp_path, "s.yaml", json.dumps(BALL)))
    before = set(children(os.getpid()))
    with LocalPool(made.plan, 8) as pool:
        next(iter(pool.rows(made.runs)))
        assert len(set(children(os.getpid())) - before) == len(made.runs) == 2


def test_the_pool_gives_back_what_is_left_when_it_is_closed(tmp_path):
    write(tmp_path, "w.sdf", WORLD)
    made = sweep.read(write(tmp_path, "s.yaml", json.dumps(BALL)))
    with LocalPool(made.plan, 1) as pool:
        next(iter(pool.rows(made.runs)))
        workers = children(os.getpid())
        assert workers
    assert not set(children(os.getpid())) & set(workers)
