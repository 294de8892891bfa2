"""What a step of each engine costs, and how true it is, in one run: run by tools/bench engines [COUNT...] [--csv FILE].

Engines take turns within each world, so that a noisy machine is noisy for all. What is timed is processor time, of
steps of 1 ms; the error is measured on its own, at 1 ms and at other steps, for the plot of error against cost.
"""

import argparse
import csv
import os
import resource
import statistics
import sys
import time

import worlds
from engines import load

STEP = 0.001
ROUNDS = 5
#: A slice longer than that [s] is cut, so that slow engines do not take all day.
LONGEST = 1.0
#: An engine that takes more processor time [s] to make a world and some steps is left out of it.
PATIENCE = 30


def slice_cost(made, count):
    """Processor time of a step [us], of `count` steps or as many as fit."""
    begin = time.process_time()
    done = 0
    while done < count and (done == 0 or time.process_time() - begin < LONGEST):
        part = min(count - done, max(1, count // 10))
        made.step(part)
        done += part
    return 1e6 * (time.process_time() - begin) / done


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
    times = [[] for _ in engines]
    for _ in range(ROUNDS):
        for each, found in zip(made, times):
            found.append(slice_cost(each, case.measured))
    for engine, each, found in zip(engines, made, times):
        each.close()
        error = case.error(engine.Engine, STEP)
        rows.append([case.name, engine.NAME, STEP, statistics.median(found), min(found), max(found), error, case.unit])
    show(rows[-len(engines) :])


def show(rows):
    ours = rows[0][3]
    for name, engine, _, cost, least, most, error, unit in rows:
        said = "" if error is None else f"{error:12.2e} {unit}"
        print(f"{name:<22} {engine:<14} {cost:12.1f} ({least:.1f} to {most:.1f}) {cost / ours:8.2f} {said}", flush=True)


def other_steps(case, engines, rows):
    """The same at other lengths of a step: what accuracy costs."""
    for step in (0.0005, 0.002, 0.004):
        for engine in engines:
            made = prepare(engine, case, step)
            cost = statistics.median(slice_cost(made, case.measured) for _ in range(3))
            made.close()
            rows.append([case.name, engine.NAME, step, cost, cost, cost, case.error(engine.Engine, step), case.unit])


def main():
    parser = argparse.ArgumentParser(prog="tools/bench engines", description="Engines side by side.")
    parser.add_argument("count", nargs="*", type=int, default=[1, 10, 50, 200, 1000], help="how many robots")
    parser.add_argument("--only", default="", help="worlds whose name contains this")
    parser.add_argument("--csv", default="", help="a file for all numbers, which plot.py draws")
    options = parser.parse_args()
    if any(count < 1 for count in options.count):
        parser.error("a number of robots is at least 1")
    engines, rows = load(), []
    print(f"processor time of a step of 1 ms [us], medians of {ROUNDS} by turns; in times of pongsim's; error")
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
            writer.writerow(["world", "engine", "step [s]", "cost [us]", "least", "most", "error", "unit"])
            writer.writerows(rows)


if __name__ == "__main__":
    sys.exit(main())
