#!/usr/bin/env python3
"""Worlds that are reset, saved, restored, spawned into, removed from and changed for hours, among those who listen.

One hash for each kind of cycle; memory, descriptors and threads stay as they are; a line every so often; exit code 1 at the
first fault, which is said. `tools/soak --help` says the rest.
"""

import argparse
import collections
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "support"))

import pongsim  # noqa: E402
from cycles import KINDS, PERIOD, SAME_BITS  # noqa: E402
from daemon import DEADLINE, Daemon, Fault, Footprint  # noqa: E402
from embedded import SENSORS, Embedded, world_texts  # noqa: E402
from listeners import Listeners  # noqa: E402
from test_domain import take_domain  # noqa: E402

WORLDS = HERE / "worlds.sdf"
#: Rounds before the first measurement and between two: six cycles of each kind.
BEGIN = 42
MEASURED = 21
#: In the first rounds memory may grow: all kinds of listeners meet all topics, and the allocator's pools fill.
WARM_UP = 252
#: Memory may also grow in this part of the run.
WARM_UP_PART = 0.1
#: The warm-up starts again when rounds are faster than ever before by this factor, because then more messages wait for
#: listeners at a time.
FASTER = 1.25
#: Measurements in a window, of which the smallest counts: messages that wait for slow listeners, or are kept for a while
#: after these have gone, sometimes take 20 MB.
WINDOW = 120
#: How much a window's smallest value may grow until the run is twice as long [bytes]; then the comparison starts anew. After
#: a time of high load the allocator may keep some MB more, but only once. A leak goes on: one of 500 bytes a round exceeds
#: this within two hours at ten rounds a second.
GROWTH = 12 << 20
#: How much more than the smallest value may be used at any time [bytes].
WAITING = 64 << 20
#: One in this many rounds may be given up, because a busy machine did not run the daemon.
MOST_LOST = 100


class Record:
    """The hashes of each kind of cycle of each world."""

    def __init__(self):
        self._first = {}
        self.compared = 0

    def check(self, world, kind, hashes):
        """hashes: of the whole cycle, in order, or the last of them. Raises Fault where they are not those of before."""
        bits = (world, SAME_BITS.get(kind, kind))
        known = self._first.get(bits, hashes)
        self._first[bits] = max(known, hashes, key=len)
        self.compared += 1
        both = min(len(known), len(hashes))
        if known[-both:] != hashes[-both:]:
            raise Fault(f"'{world}', cycle '{kind}': hashes {hashes}, before {known}")


class WarmUp:
    """Whether memory may still grow."""

    def __init__(self, now, seconds=0):
        """now: in seconds; seconds: how long the run takes."""
        self._fastest = 0
        self._before = now, 0
        self._until = WARM_UP
        self._end = now + WARM_UP_PART * seconds

    def goes_on(self, now, rounds):
        """Asked at each measure, with the seconds and the rounds up to it."""
        seconds, done = now - self._before[0], rounds - self._before[1]
        self._before = now, rounds
        pace = done / max(seconds, 1e-3)
        if rounds <= WARM_UP:
            self._fastest = max(self._fastest, pace)
        elif pace > FASTER * self._fastest:
            self._fastest = pace
            self._until = rounds + WARM_UP
        return rounds <= self._until or now < self._end


class Bound:
    """What a process may take: GROWTH more than the least memory of the warm-up's last window or, later, of the window when
    the run had last become twice as long; at any time WAITING more than that least; and as many descriptors and threads as
    at first."""

    def __init__(self, what, footprint, patience=DEADLINE):
        """footprint: gives it. patience: how long others may take to leave nothing behind [s]."""
        self._what = what
        self._footprint = footprint
        self._patience = patience
        self._first = None
        self._least = None
        self._measures = self._counted_from = 0
        self._window = collections.deque(maxlen=WINDOW)

    def measure(self, is_warm):
        """Waits until what others have left behind is gone, and raises Fault where it does not go or memory grows."""
        end = time.monotonic() + self._patience
        now = self._footprint()
        if self._first is None:
            # the library briefly opens a descriptor now and then, to list sockets: take the lowest of several counts
            looks = [now]
            for _ in range(20):
                time.sleep(0.005)
                looks.append(self._footprint())
            descriptors = min(look.descriptors for look in looks)
            self._first = Footprint(now.memory, descriptors, min(look.threads for look in looks))
        first = self._first
        while (now.descriptors, now.threads) != (first.descriptors, first.threads):
            if time.monotonic() > end:
                raise Fault(f"{self._what} takes {now}, at first {first}")
            time.sleep(0.1)
            now = self._footprint()
        self._window.append(now.memory)
        self._measures += 1
        least = min(self._window)
        if is_warm and (least > self._least + GROWTH or now.memory > self._least + WAITING):
            raise Fault(f"the memory of {self._what} grows: {now}, of late at least {least}, before {self._least} bytes")
        if not is_warm or self._measures >= 2 * self._counted_from:
            self._least, self._counted_from = least, self._measures


class Soak:
    """One run."""

    def __init__(self, program, seconds, folder):
        domain = take_domain()
        environment = dict(os.environ, PONGSIM_DOMAIN=str(domain))
        self._record = Record()
        self._daemon = Daemon(program, str(WORLDS), PERIOD, environment, os.path.join(folder, "daemon"))
        self._listeners = Listeners(program, environment)
        self._embedded = {name: Embedded(text) for name, text in world_texts(WORLDS).items()}
        client = "<sdf version='1.9'><world name='soak_client'/></sdf>"
        self._client = pongsim.Simulation(client, load_systems=False, network=True, domain=domain)
        self._heard = dict.fromkeys(SENSORS, 0)
        for name in SENSORS:
            self._client.subscribe(f"/soak/{name}", lambda _, name=name: self._hear(name), type=bytes)
        pids = {"the daemon": self._daemon.process.pid, "the driver": os.getpid()}
        self._bounds = [Bound(what, lambda pid=pid: Footprint.of(pid)) for what, pid in pids.items()]
        self._next_measure = BEGIN
        self._warm_up = WarmUp(time.monotonic(), seconds)
        self.lost = 0
        self.rounds = 0
        self.measures = 0

    def _hear(self, name):
        self._heard[name] += 1

    def round(self):
        """One cycle of each world in the daemon, all at once, and one of one world here."""
        is_due = self.rounds >= self._next_measure
        self._listeners.visit(begins=not is_due)
        if is_due and self._listeners.is_idle:
            self._measure()
            self._next_measure = self.rounds + MEASURED
        cycles = {}
        for i, world in enumerate(self._embedded):
            kind = KINDS[(self.rounds + i) % len(KINDS)]
            cycles[world] = (kind.__name__, kind(lambda service, request, type, world=world: self._ask(world, service, request, type)))
        self._run_or_lose(cycles)
        world = list(self._embedded)[self.rounds % len(self._embedded)]
        for kind, number in self._embedded[world].run():
            self._record.check(world, kind, [number])
        self.rounds += 1

    def _run_or_lose(self, cycles):
        """Gives the cycles up where the daemon was out of sight, as it is where the machine lets it wait for six seconds."""
        try:
            self._run(cycles)
        except pongsim.ServiceError as error:
            self.lost += 1
            print(f"  round {self.rounds} given up: {error}", flush=True)
            if self.lost > 2 + self.rounds // MOST_LOST:
                raise Fault(f"{self.lost} of {self.rounds} rounds were given up") from None
            for world in cycles:
                self._ask(world, "control", {"pause": True}, "WorldControl")

    def _run(self, cycles):
        done = dict.fromkeys(cycles, 0)
        hashes = {world: [] for world in cycles}
        going = dict(cycles)
        while going:
            steps = {}
            for world, (_, cycle) in list(going.items()):
                steps[world] = next(cycle, 0)
                if done[world] == 0:
                    self._daemon.forget(world)
                if steps[world] == 0:
                    del going[world]
                else:
                    self._ask(world, "control", {"pause": True, "multi_step": steps[world]}, "WorldControl")
            self._listeners.stop()
            for world in going:
                until = done[world] + steps[world]
                hashes[world] += self._daemon.hashes(world, list(range(done[world] + PERIOD, until + 1, PERIOD)))
                done[world] = until
            self._client.dispatch()
        for world, (kind, _) in cycles.items():
            self._record.check(world, kind, hashes[world])

    def _ask(self, world, service, request, type):
        """The timeout is that of looking for the service, too, if the daemon has just been out of sight."""
        answer = self._client.request(f"/world/{world}/{service}", request, type=type, timeout=DEADLINE)
        if not answer.get("data"):
            raise Fault(f"'{world}' refuses {service} {request}")

    def _measure(self):
        is_warm = not self._warm_up.goes_on(time.monotonic(), self.rounds)
        for bound in self._bounds:
            bound.measure(is_warm)
        said = [line for line in self._daemon.said().splitlines() if "error" in line]
        if said:
            raise Fault("the daemon says: " + said[0])
        here = {name: sum(embedded.heard[name] for embedded in self._embedded.values()) for name in SENSORS}
        for name in SENSORS:
            if self._heard[name] == 0 or here[name] == 0:
                raise Fault(f"the {name} is not heard: {self._heard} of the daemon, {here} here")
        self.measures += 1

    def line(self, seconds):
        """What has been up to now."""
        daemon = Footprint.of(self._daemon.process.pid)
        own = Footprint.of(os.getpid())
        return (
            f"{seconds:8.0f} {self.rounds:8} {self._record.compared:9} {daemon.memory / 2**20:10.1f} {daemon.descriptors:6}"
            f" {daemon.threads:7} {own.memory / 2**20:10.1f} {sum(self._heard.values()):10} {self._listeners.came:6}"
            f" {self._listeners.killed:6} {self.lost:5} {self.measures:8}"
        )

    def end(self):
        """Ends all as it has to end."""
        self._listeners.end()
        self._client.close()
        for embedded in self._embedded.values():
            embedded.close()
        self._daemon.end()

    def kill(self):
        self._listeners.end()
        self._daemon.kill()


HEAD = (
    f"{'s':>8} {'rounds':>8} {'compared':>9} {'daemon MB':>10} {'files':>6} {'threads':>7} {'driver MB':>10} {'messages':>10}"
    f" {'came':>6} {'killed':>6} {'lost':>5} {'measures':>8}"
)


class Beside:
    """The soak of the transport, which runs at the same time and writes into a file."""

    def __init__(self, program, minutes, folder):
        self._file = os.path.join(folder, "subscribers")
        with open(self._file, "wb") as output:
            self._process = subprocess.Popen([program, str(minutes)], stdout=output, stderr=subprocess.STDOUT)

    def check(self, wait=False):
        """Raises Fault where it has failed, and waits for its end if it is to."""
        if wait:
            self._process.wait()
        if self._process.poll() not in (None, 0):
            raise Fault("among the subscribers: " + " ".join(line for line in self._said() if line.strip() and line[0] not in " 0123456789"))

    def line(self):
        return self._said()[-1]

    def _said(self):
        with open(self._file, encoding="utf-8", errors="replace") as text:
            return text.read().strip().splitlines() or ["nothing yet"]

    def kill(self):
        self._process.kill()
        self._process.wait()


def go_on(soak, beside, arguments):
    """Rounds and lines until the time is over and something was measured, then an orderly end. Raises Fault at the first
    fault."""
    start = time.monotonic()
    seconds = arguments.minutes * 60
    lines, next_line = 0, arguments.every
    print(HEAD, flush=True)
    while (now := time.monotonic() - start) < seconds or soak.rounds < arguments.rounds or soak.measures == 0:
        soak.round()
        if beside:
            beside.check()
        if now >= next_line:
            next_line = now + arguments.every
            lines += 1
            print(soak.line(now), flush=True)
            if beside and lines % 10 == 0:
                print("  subscribers:", beside.line(), flush=True)
    print(soak.line(now), flush=True)
    soak.end()
    if beside:
        beside.check(wait=True)
        print("  subscribers:", beside.line())


def run(arguments):
    """Returns the exit code."""
    soak = beside = None
    with tempfile.TemporaryDirectory() as folder:
        try:
            soak = Soak(arguments.program, arguments.minutes * 60, folder)
            if arguments.subscribers:
                beside = Beside(arguments.subscribers, max(1, int(arguments.minutes)), folder)
            go_on(soak, beside, arguments)
        except (Fault, pongsim.Error) as fault:
            print(f"FAILED in round {soak.rounds if soak else 0}: {fault}", flush=True)
            return 1
        finally:
            if soak:
                soak.kill()
            if beside:
                beside.kill()
    print("fine")
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--program", required=True, help="the program pongsim")
    parser.add_argument("--subscribers", help="the program pongsim_transport_soak, to run beside")
    parser.add_argument("--minutes", type=float, default=15, help="how long (15)")
    parser.add_argument("--rounds", type=int, default=0, help="at least so many rounds, however long they take (0)")
    parser.add_argument("--every", type=float, default=30, help="seconds between two lines (30)")
    # so that the processes that were started are ended
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
    return run(parser.parse_args())


if __name__ == "__main__":
    sys.exit(main())
