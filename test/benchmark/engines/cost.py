"""What a step of each engine costs, and how true it is, in one run: run by tools/bench engines [COUNT...] [--csv FILE].

Engines take turns within each world, so that a noisy machine is noisy for all. What is timed is processor time, of
steps of 1 ms, and wall time: the best decile of short slices, in which nobody else had the processor. The error is
measured on its own, at 1 ms and at other steps, for the plot of error against cost.
"""

import argparse
import csv
import os
import resource
import statistics
import sys
import time

import accuracy
import worlds
from engines import load

STEP = 0.001
ROUNDS = 5
#: Longest slice [s]: slow engines make fewer steps.
LONGEST = 1.0
#: An engine that needs more processor time [s] to load a world and make some steps is left out.
PATIENCE = 30


def slice_cost(made, count):
    """Processor time of a step [us], of `count` steps or as many as fit, and wall times of a step in parts of it."""
    begin = time.process_time()
    done = 0
    walls = []
    while done < count and (done == 0 or time.process_time() - begin < LONGEST):
        part = min(count - done, max(1, count // 10))
        start = time.perf_counter()
        made.step(part)
        walls.append(1e6 * (time.perf_counter() - start) / part)
        done += part
    return 1e6 * (time.process_time() - begin) / done, walls


def best_decile(values):
    """The value that a tenth of them do not exceed."""
    return sorted(values)[(len(values) - 1) // 10]


def settle(made, case):
    """Makes the steps before those that count, or as many as fit into some seconds."""
    begin = time.process_time()
    for _ in range(case.skipped // 10):
        made.step(10)
        if time.process_time() - begin > 10 * LONGEST:
            return False
    return True


def bears(engine, case):
    """Whether the engine gets through some steps, tried in a process that can be ended within a step."""
    child = os.fork()
    if child == 0:
        resource.setrlimit(resource.RLIMIT_CPU, (PATIENCE, PATIENCE))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        engine.Engine(case.scene(), STEP).step(60)
        os._exit(0)
    return os.waitpid(child, 0)[1] == 0


def takes(engine, case):
    """Whether the world is one for the engine; says why not."""
    most = getattr(engine, "MOST_CONTACTS", None)
    why = ""
    if most is not None and case.contacts > most:
        why = f"more than {most} points of contact"
    elif not bears(engine, case):
        why = f"more than {PATIENCE} s for 60 steps"
    if why:
        print(f"{case.name:<22} {engine.NAME:<14} {why}", flush=True)
    return not why


def prepare(engine, case, step=STEP):
    made = engine.Engine(case.scene(), step)
    if settle(made, case) and step == STEP:
        case.check(made)
    return made


def compare(case, engines, rows):
    engines = [engine for engine in engines if takes(engine, case)]
    made = [prepare(engine, case) for engine in engines]
    times, walls = [[] for _ in engines], [[] for _ in engines]
    for _ in range(ROUNDS):
        for i, each in enumerate(made):
            cost, parts = slice_cost(each, case.measured)
            times[i].append(cost)
            walls[i] += parts
    for engine, each, found, wall in zip(engines, made, times, walls):
        each.close()
        error = case.error(engine.Engine, STEP)
        cost = [statistics.median(found), min(found), max(found), best_decile(wall)]
        rows.append([case.name, engine.NAME, STEP, *cost, error, case.unit])
    show(rows[-len(engines) :])


def show(rows):
    _, _, _, our_cost, _, _, our_wall, _, _ = rows[0]
    for name, engine, _, cost, least, most, wall, error, unit in rows:
        said = "" if error is None else f"{error:12.2e} {unit}"
        span = f"({least:.1f} to {most:.1f})"
        print(f"{name:<22} {engine:<14} {cost:12.1f} {span:<22} {cost / our_cost:8.2f} {wall:12.1f} "
              f"{wall / our_wall:8.2f} {said}", flush=True)


def other_steps(case, engines, rows):
    """The same at other lengths of a step: what accuracy costs."""
    for step in (0.0005, 0.002, 0.004):
        for engine in engines:
            made = prepare(engine, case, step)
            slices = [slice_cost(made, case.measured) for _ in range(3)]
            cost = statistics.median(cost for cost, _ in slices)
            wall = best_decile([wall for _, parts in slices for wall in parts])
            made.close()
            error = case.error(engine.Engine, step)
            rows.append([case.name, engine.NAME, step, cost, cost, cost, wall, error, case.unit])


def at_same_error(engines, only):
    """Of pongsim and of MuJoCo with two of its integrators, in the worlds of single robots of many links."""
    classes = {"pongsim": engines[0].Engine}
    for engine in engines:
        if engine.NAME.startswith("MuJoCo"):
            classes |= {"MuJoCo": engine.Engine, "MuJoCo, RK4": engine.RungeKutta}
    print(f"processor time of a simulated second [ms], medians of {ROUNDS} by turns, and errors, by the length of a step")
    for case in worlds.on_trees():
        if case.count == 1 and only in case.name:
            accuracy.compare(case, classes, ROUNDS)


def main():
    parser = argparse.ArgumentParser(prog="tools/bench engines", description="Engines side by side.")
    parser.add_argument("count", nargs="*", type=int, default=[1, 10, 50, 200, 1000], help="how many robots")
    parser.add_argument("--only", default="", help="worlds whose name contains this")
    parser.add_argument("--csv", default="", help="a file for all numbers, which plot.py draws")
    parser.add_argument("--accuracy", action="store_true", help="the cost of robots of many links at the same error")
    options = parser.parse_args()
    if any(count < 1 for count in options.count):
        parser.error("a number of robots is at least 1")
    engines, rows = load(), []
    if options.accuracy:
        return at_same_error(engines, options.only)
    print(f"a step of 1 ms: processor time [us], medians of {ROUNDS} by turns (least to most), in times of pongsim's; "
          "wall time [us], best decile, in times of pongsim's; error")
    cases = [case for case in worlds.cases(options.count) if options.only in case.name]
    if not cases:
        parser.error(f"there is no world with '{options.only}' in its name")
    for case in cases:
        compare(case, engines, rows)
    if options.csv:
        for case in cases:
            if case.name in ("robots x1", *worlds.ON_JOINTS):
                other_steps(case, engines, rows)
        with open(options.csv, "w", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(["world", "engine", "step [s]", "cost [us]", "least", "most", "wall [us]", "error", "unit"])
            writer.writerows(rows)


if __name__ == "__main__":
    sys.exit(main())
