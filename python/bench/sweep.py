"""What a sweep costs beside its steps alone: run by tools/bench sweep WORLD [RUNS].

The steps alone are those of one simulation, set back to its start before each run, in a process for each processor at the
same time. Both are taken by turns, for the speed of machines changes from minute to minute."""

import json
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

from pongsim import sweep
from pongsim.sweep.runner import processors

WORLD = pathlib.Path(sys.argv[1]).resolve()
RUNS = int(sys.argv[2]) if len(sys.argv) > 2 else 200
#: Simulated time of a run [s].
LENGTH = 10
ROUNDS = 5

ALONE = f"""
import sys, pongsim
sim = pongsim.Simulation({str(WORLD)!r})
sys.stdout.write("ready\\n")
sys.stdout.flush()
sys.stdin.readline()
for seed in range(int(sys.argv[1])):
    sim.reset(seed)
    sim.run_until({LENGTH})
"""

MEASURES = {"x": {"topic": "/model/pong_bot/odometry", "field": "pose.position.x", "take": "max"}}
TOUCHED = "//model[@name='pong_bot']/link[@name='chassis']/inertial/mass"


def steps_alone(runs, jobs):
    """Wall time of the steps of so many runs [s]."""
    processes = [subprocess.Popen([sys.executable, "-c", ALONE, str(runs // jobs)], stdin=subprocess.PIPE,
                                  stdout=subprocess.PIPE, text=True) for _ in range(jobs)]
    for process in processes:
        process.stdout.readline()
    begin = time.monotonic()
    for process in processes:
        process.stdin.write("go\n")
        process.stdin.flush()
    for process in processes:
        process.wait()
    return time.monotonic() - begin


def swept(runs, jobs, changed):
    """Wall time of a sweep of so many runs, all in all [s]: seeds, or each with a world of its own."""
    made = {"world": str(WORLD), "duration": LENGTH, "measures": MEASURES}
    if changed:
        made["parameters"] = {"mass": {"xpath": TOUCHED, "range": {"from": 3, "to": 5, "count": runs}}}
    else:
        made["seeds"] = runs
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "s.yaml")
        file.write_text(json.dumps(made))
        begin = time.monotonic()
        results = sweep.run(file, jobs=jobs, parquet=False)
        taken = time.monotonic() - begin
        if results.failed:
            raise SystemExit(f"a run has failed: {results.failed[0].reason}")
    return taken


jobs = processors()
runs = RUNS // ROUNDS // jobs * jobs
print(f"{runs * ROUNDS} runs of {LENGTH} simulated seconds in {ROUNDS} rounds, {jobs} at a time; wall time, start to end")
alone, seeds, worlds = [], [], []
for _ in range(ROUNDS):
    alone.append(steps_alone(runs, jobs))
    seeds.append(swept(runs, jobs, False))
    worlds.append(swept(runs, jobs, True))
for name, taken in (("the steps alone", alone), ("a sweep over seeds", seeds), ("a sweep that changes the world", worlds)):
    ratios = [each / base for each, base in zip(taken, alone)]
    print(f"{name:<34} {statistics.median(taken) / runs * 1000:8.1f} ms a run   {statistics.median(ratios):.3f} of the steps"
          f"  ({min(ratios):.3f} to {max(ratios):.3f})")
