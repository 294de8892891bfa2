"""What a sweep costs beside its steps alone: run by tools/bench sweep WORLD [RUNS].

The steps alone are those of one simulation, set back to its start before each run, in a process for each processor at the
same time. Both are taken by turns, for the speed of machines changes from minute to minute."""

import json
import os
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
import time
print(time.process_time(), flush=True)
sys.stdin.readline()
for seed in range(int(sys.argv[1])):
    sim.reset(seed)
    sim.run_until({LENGTH})
"""

MEASURES = {"x": {"topic": "/model/pong_bot/odometry", "field": "pose.position.x", "take": "max"}}
TOUCHED = "//model[@name='pong_bot']/link[@name='chassis']/inertial/mass"


def timed(work):
    """Wall time of it, and the processors' time of it with that of the processes that it has started [s]."""
    times, begin = os.times(), time.monotonic()
    work()
    wall, ended = time.monotonic() - begin, os.times()
    return wall, sum(ended[:4]) - sum(times[:4])


def steps_alone(runs, jobs):
    """The steps of so many runs and nothing else: what making the processes takes is left out."""
    processes = [subprocess.Popen([sys.executable, "-c", ALONE, str(runs // jobs)], stdin=subprocess.PIPE,
                                  stdout=subprocess.PIPE, text=True) for _ in range(jobs)]
    begun = sum(float(process.stdout.readline()) for process in processes)

    def work():
        for process in processes:
            process.stdin.write("go\n")
            process.stdin.flush()
        for process in processes:
            process.wait()

    wall, processor = timed(work)
    return wall, processor - begun


def swept(runs, jobs, changed):
    """A sweep of so many runs, all in all: over seeds, or with a world of its own for each."""
    made = {"world": str(WORLD), "duration": LENGTH, "measures": MEASURES}
    if changed:
        made["parameters"] = {"mass": {"xpath": TOUCHED, "range": {"from": 3, "to": 5, "count": runs}}}
    else:
        made["seeds"] = runs
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "s.yaml")
        file.write_text(json.dumps(made))
        results = []
        taken = timed(lambda: results.append(sweep.run(file, jobs=jobs, parquet=False)))
    if results[0].failed:
        raise SystemExit(f"a run has failed: {results[0].failed[0].reason}")
    return taken


jobs = processors()
runs = RUNS // ROUNDS // jobs * jobs
print(f"{runs * ROUNDS} runs of {LENGTH} simulated seconds in {ROUNDS} rounds, {jobs} at a time; wall time and processors'"
      " time, from start to end")
alone, seeds, worlds = [], [], []
for _ in range(ROUNDS):
    alone.append(steps_alone(runs, jobs))
    seeds.append(swept(runs, jobs, False))
    worlds.append(swept(runs, jobs, True))
for name, taken in (("the steps alone", alone), ("a sweep over seeds", seeds), ("a sweep that changes the world", worlds)):
    for i, clock in enumerate(("wall", "processors")):
        ratios = [each[i] / base[i] for each, base in zip(taken, alone)]
        per_run = statistics.median(each[i] for each in taken) / runs * 1000
        print(f"{name:<31} {clock:<10} {per_run:7.1f} ms a run   {statistics.median(ratios):.3f} of the steps"
              f"  ({min(ratios):.3f} to {max(ratios):.3f})")
