"""What a suite of short scenarios costs beside its steps alone: run by tools/bench scenarios WORLD [COUNT].

Each scenario is a file of its own with one run of a second. The steps alone are those of simulations that are loaded
already, in a process for each processor at the same time. Both are taken by turns, for the speed of machines changes from
minute to minute."""

import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

from pongsim.sweep.runner import processors

WORLD = pathlib.Path(sys.argv[1]).resolve()
COUNT = int(sys.argv[2]) if len(sys.argv) > 2 else 100
ROUNDS = 5
#: Of each scenario [s], beside its share of the steps.
ALLOWED = 0.1

SCENARIO = f"""world: {WORLD}
duration: 1
publish: [{{topic: /cmd_vel, message: {{linear: {{x: 0.5}}}}}}]
expect:
  - topic: /model/pong_bot/odometry
    eventually: {{twist.linear.x: {{near: 0.5, tolerance: 0.1}}}}
  - pose: pong_bot
    always: {{z: {{near: 0, tolerance: 0.1}}}}
  - contact: [pong_bot, court]
    never: true
"""

ALONE = f"""
import sys, pongsim
sim = pongsim.Simulation({str(WORLD)!r})
print("ready", flush=True)
sys.stdin.readline()
for seed in range(int(sys.argv[1])):
    sim.reset(seed)
    sim.publish("/cmd_vel", {{"linear": {{"x": 0.5}}}})
    sim.run_until(1)
"""
TEST = "import sys; from pongsim.testing.command import main; sys.exit(main())"


def steps_alone(jobs):
    """Wall time of the steps of all scenarios [s]."""
    processes = [subprocess.Popen([sys.executable, "-c", ALONE, str(COUNT // jobs)], stdin=subprocess.PIPE,
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


def suite(folder):
    """Wall time of the suite, from the start of the program to its end [s]."""
    begin = time.monotonic()
    subprocess.run([sys.executable, "-c", TEST, *sorted(folder.glob("*.yaml"))], check=True, stdout=subprocess.DEVNULL)
    return time.monotonic() - begin


def main():
    """Prints both, and what is allowed."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for i in range(COUNT):
            (folder / f"s{i:04}.yaml").write_text(SCENARIO)
        jobs = processors()
        rounds = [(steps_alone(jobs), suite(folder)) for _ in range(ROUNDS)]
    alone, whole = (statistics.median(each) for each in zip(*rounds))
    print(f"{COUNT} scenarios of 1 s on {jobs} cores, medians of {ROUNDS}: {whole:.2f} s; their steps alone {alone:.2f} s")
    print(f"{1000 * (whole - 1.2 * alone) / COUNT:.1f} ms each beside 1.2 times the steps; allowed: {1000 * ALLOWED:.0f} ms")


main()
