"""The program `pongsim run` with several worlds, and what a process takes of the machine."""

import dataclasses
import os
import re
import select
import signal
import subprocess
import threading
import time

#: After this time something counts as failed, even on a busy machine [s].
DEADLINE = 300
HASH = re.compile(r"state hash of (\w+) after (\d+): ([0-9a-f]{16})")


class Fault(Exception):
    """Something is not as it has to be."""


@dataclasses.dataclass(frozen=True)
class Footprint:
    """What a process takes: bytes of memory, open descriptors, threads.

    Memory is what is the process's own. Pages of files that it has mapped, libraries above all, come and go with what else
    the machine does: another program that reads them makes them part of this process's resident memory, too.
    """

    memory: int
    descriptors: int
    threads: int

    @staticmethod
    def of(pid):
        with open(f"/proc/{pid}/status", encoding="ascii") as lines:
            said = dict(line.split(":", 1) for line in lines)
        memory = sum(int(said[kind].split()[0]) * 1024 for kind in ("RssAnon", "RssShmem"))
        return Footprint(memory, len(os.listdir(f"/proc/{pid}/fd")), int(said["Threads"]))


class Daemon:
    """`pongsim run`, paused, as fast as it goes, with a hash of each world's state every so many steps."""

    def __init__(self, program, worlds, period, environment, errors):
        """errors: a file for what it says on stderr."""
        self._errors = errors
        self._rest = b""
        self._hashes = {}
        self._reading = threading.Condition()
        self._end = None
        command = [program, "run", worlds, "--paused", "-z", "0", "--hash-every", str(period)]
        with open(errors, "wb") as error:
            self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=error, env=environment)
        end = time.monotonic() + DEADLINE
        while self.said().count("pongsim: world '") < 3:
            if self.process.poll() is not None or time.monotonic() > end:
                raise Fault("the daemon does not start: " + self.said())
            time.sleep(0.02)
        # read its output, because a full pipe would block the world while we may wait for its response
        threading.Thread(target=self._drain, daemon=True).start()

    def _drain(self):
        try:
            while True:
                if select.select([self.process.stdout], [], [], 1)[0]:
                    with self._reading:
                        self._take()
                        self._reading.notify()
        except (Fault, OSError, ValueError) as end:
            with self._reading:
                self._end = end
                self._reading.notify()

    def said(self):
        """All that it has said on stderr."""
        with open(self._errors, encoding="utf-8", errors="replace") as text:
            return text.read()

    def forget(self, world):
        """Drops the hashes that a world has printed up to now."""
        with self._reading:
            while self._take():
                pass
            self._hashes.pop(world, None)

    def hashes(self, world, steps):
        """The next hashes of a world, which must be those after these numbers of steps."""
        with self._reading:
            mine = self._hashes.setdefault(world, [])
            self._reading.wait_for(lambda: self._end or len(mine) >= len(steps), DEADLINE)
        if len(mine) < len(steps):
            raise Fault(self._end or f"'{world}' makes no steps: {mine} in place of those after {steps}")
        if [at for at, _ in mine[: len(steps)]] != steps:
            raise Fault(f"'{world}' missed a reset: hashes after {mine}, where those after {steps} have to come")
        taken = [number for _, number in mine[: len(steps)]]
        del mine[: len(steps)]
        return taken

    def _take(self):
        """Takes what has been printed; whether there was anything. Raises Fault where nothing more will come."""
        if not select.select([self.process.stdout], [], [], 0)[0]:
            return False
        data = os.read(self.process.stdout.fileno(), 65536)
        if not data:
            raise Fault(f"the daemon has ended with code {self.process.wait()}: {self.said()}")
        *lines, self._rest = (self._rest + data).split(b"\n")
        for line in lines:
            found = HASH.fullmatch(line.decode())
            if found is None:
                raise Fault(f"the daemon prints: {line!r}")
            self._hashes.setdefault(found[1], []).append((int(found[2]), found[3]))
        return True

    def end(self):
        """Ends it by Ctrl-C, as a user would."""
        self.process.send_signal(signal.SIGINT)
        with self._reading:
            self.process.stdout.close()
        try:
            code = self.process.wait(DEADLINE)
        except subprocess.TimeoutExpired:
            raise Fault("the daemon does not end") from None
        if code != 0:
            raise Fault(f"the daemon ends with code {code}: {self.said()}")

    def kill(self):
        """Ends it however it is."""
        self.process.kill()
        self.process.wait()
