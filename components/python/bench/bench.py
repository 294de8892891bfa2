"""What Python costs beside C++: run by tools/bench python, which says what the C++ program has measured."""

import statistics
import subprocess
import sys
import time

import pongsim

WORLD, OTHER = sys.argv[1], sys.argv[2]
ROUNDS, STEPS = 15, 4000


def per_call(work, times):
    begin = time.process_time_ns()
    for _ in range(times):
        work()
    return (time.process_time_ns() - begin) / times / 1000


def show(name, values):
    print(f"{name:<44} {statistics.median(values):8.3f}  ({min(values):.3f} to {max(values):.3f})")


print("microseconds of processor time, medians of", ROUNDS, "rounds, C++ and Python by turns")
inner, outer, extra, restores, resets, poses = [], [], [], [], [], []
sim = pongsim.Simulation(WORLD)
start = sim.save()
for _ in range(ROUNDS):
    # the same steps of the same world, from the same state
    sim.restore(start)
    sim.step(100)
    inner.append(float(subprocess.run([OTHER, WORLD, str(STEPS)], capture_output=True, text=True, check=True).stdout))
    outer.append(per_call(sim.step, STEPS))
    extra.append(outer[-1] - inner[-1])
    restores.append(per_call(lambda: sim.restore(start), 500))
    resets.append(per_call(sim.reset, 100))
    poses.append(per_call(sim.poses, 500))
show("step(1) in C++", inner)
show("step(1) from Python", outer)
show("what Python adds to a step", extra)
show("restore(state)", restores)
show("reset()", resets)
show("poses() of all models", poses)
