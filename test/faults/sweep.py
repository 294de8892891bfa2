#!/usr/bin/env python3
"""Lets each allocation, file operation, thread start and socket call of a run fail in turn, one run each; those allocations
during which a model is inserted or removed once more.

A run must end as it would have, or with exit code 1 and an error, or say what it is without; it never crashes or hangs, and
what it has recorded can be read. Exit code 1 where one does not, with what it was.
"""

import argparse
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import threading

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))

from test_domain import take_domain  # noqa: E402

WORLD = HERE / "world.sdf"
KINDS = ("memory", "file", "thread", "socket", "edit")
#: Time for a continuing process to end, on a busy machine [s].
DEADLINE = 120
#: Exit codes of an orderly end: done, failed, an option of an extension that could not be read.
ORDERLY = (0, 1, 2)


class Run:
    """The result of a run with one fault."""

    def __init__(self, arguments, folder, environment):
        self.folder = pathlib.Path(folder)
        self.timed_out = False
        command = [arguments.program, "run", str(WORLD), "-z", "0", "--iterations", "20", "--hash"]
        command += ["--record-path", str(self.folder / "recording")] if arguments.record else []
        try:
            done = subprocess.run(
                command, env=environment, cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, timeout=DEADLINE
            )
        except subprocess.TimeoutExpired as late:
            self.timed_out, self.code = True, None
            self.output, self.error = (late.stdout or b"").decode(), (late.stderr or b"").decode(errors="replace")
            return
        self.code, self.output = done.returncode, done.stdout.decode()
        self.error = done.stderr.decode(errors="replace")

    @property
    def words(self):
        """pongsim's messages about the fault: without its usual ones, and those of the fault library."""
        usual = re.compile(r"faults: .*|pongsim: (recording to|world '\w+':) .*")
        return [line for line in self.error.splitlines() if not usual.fullmatch(line)]


def verdict(run, clean, program):
    """None if a run is acceptable, else why not."""
    if run.timed_out:
        return "hangs"
    if run.code not in ORDERLY:
        return f"ends with code {run.code}"
    if "crashed" in run.error or "terminate called" in run.error:
        return "crashes"
    if run.code != 0 and not any("error" in line for line in run.words):
        return "fails without a word"
    if run.code == 0 and run.output != clean.output and not run.words:
        return "does something else without a word"
    return unreadable(run, clean, program)


def recordings(run):
    """The recordings of its worlds, by their places."""
    return {str(file.relative_to(run.folder)): file for file in run.folder.glob("recording/**/state.tlog")}


def unreadable(run, clean, program):
    """What is wrong with the recordings, unless that was reported."""
    left = recordings(run)
    for place in recordings(clean):
        if run.words:
            continue
        if place not in left:
            return f"does not leave {place}, without a word"
        info = subprocess.run([program, "log", "info", str(left[place])], capture_output=True, timeout=DEADLINE)
        if info.returncode != 0:
            return f"leaves {place}, which can't be read: " + info.stderr.decode(errors="replace")
    return None


def chosen(count, samples):
    """Numbers from 1 to count: all, or so many, more of them at the beginning and end than between."""
    if not samples or count <= samples:
        return list(range(1, count + 1))
    return sorted({1 + round((count - 1) * i / (samples - 1)) for i in range(samples)})


def sweep(arguments):
    """Returns the number of unacceptable runs."""
    domain = threading.local()
    faults = 0
    with tempfile.TemporaryDirectory() as folder:

        def one(name, **fault):
            if not hasattr(domain, "number"):
                domain.number = take_domain()
            place = pathlib.Path(folder, name)
            place.mkdir()
            own = {"HOME": str(place), "LD_PRELOAD": arguments.library, "PONGSIM_DOMAIN": str(domain.number)}
            return Run(arguments, place, {**os.environ, **own, **fault})

        clean = one("clean", PONGSIM_FAULT_COUNTS=os.path.join(folder, "counts"))
        if clean.code != 0 or clean.words:
            print(f"without a fault it ends with code {clean.code}: {clean.error}")
            return 1
        with open(os.path.join(folder, "counts"), encoding="ascii") as lines:
            counts = {kind: int(number) for kind, number in (line.split() for line in lines)}

        if not all(counts.values()):
            print(f"the library of faults does not see all calls: {counts}")
            return 1

        def judge(kind, number):
            name = f"{kind}-{number}"
            run = one(name, PONGSIM_FAULT=f"{kind}:{number}")
            why = verdict(run, clean, arguments.program)
            shutil.rmtree(run.folder)
            return name, run, why

        for kind in arguments.kinds:
            numbers = [int(n) for n in arguments.only] if arguments.only else chosen(counts[kind], arguments.samples)
            codes = {}
            with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
                for name, run, why in pool.map(lambda number, kind=kind: judge(kind, number), numbers):
                    codes[run.code] = codes.get(run.code, 0) + 1
                    if arguments.verbose:
                        print(f"{name}: code {run.code}: {run.error.splitlines()}", flush=True)
                    if why:
                        faults += 1
                        print(f"{name}: {why}\n  " + "\n  ".join(run.error.splitlines()), flush=True)
            ends = ", ".join(f"{count} with code {code}" for code, count in sorted(codes.items(), key=str))
            print(f"{kind}: {len(numbers)} of {counts[kind]} calls failed in turn: {ends}", flush=True)
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", type=os.path.abspath, required=True, help="the program pongsim")
    parser.add_argument("--library", type=os.path.abspath, required=True, help="the library of faults")
    parser.add_argument("--samples", type=int, default=0, help="so many calls of each kind, from first to last; 0: all")
    parser.add_argument("--only", nargs="+", help="the calls of these numbers")
    parser.add_argument("--kinds", nargs="+", choices=KINDS, default=KINDS)
    parser.add_argument("--record", action="store_true", help="record the run")
    parser.add_argument("--verbose", action="store_true", help="say of each run what it said")
    parser.add_argument("--jobs", type=int, default=2, help="runs at once (2)")
    return 1 if sweep(parser.parse_args()) else 0


if __name__ == "__main__":
    sys.exit(main())
