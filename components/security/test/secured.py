"""Helpers for tests of secured processes: a folder with a keystore, a DDS domain, and processes."""

import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
PONGSIM = os.environ.get("PONGSIM", str(ROOT / "build/release/bin/pongsim"))
FAST_PEER = os.environ.get("PONGSIM_FAST_PEER", str(ROOT / "build/release/test/ros2_fast_peer"))
WORLD = ROOT / "worlds/pong_world.sdf"

sys.path.append(str(ROOT / "test/support"))
import waiting  # noqa: E402
from test_domain import take_domain  # noqa: E402
from waiting import PATIENCE  # noqa: E402

DOMAIN = str(take_domain())


# All running processes, whose output is part of failure messages.
_running = []


def _told():
    """The output of all processes so far, for messages of failures."""
    return "\n".join(f"{' '.join(each.args[:6])}, code {each.poll()}:\n{each.output()[-500:]}{each.said()[-2000:]}"
                     for each in _running)


def until(condition, what):
    """Like `waiting.until`; a failure also has the output of the running programs."""
    return waiting.until(condition, lambda: f"{what}\n{_told()}")


class Place:
    """A folder with a keystore 'keys', and the programs that run in it."""

    def __init__(self):
        self._folder = tempfile.TemporaryDirectory(prefix="pongsim-security-")
        self.path = pathlib.Path(self._folder.name)
        self.keys = self.path / "keys"
        kept = {name: value for name, value in os.environ.items()
                if not name.startswith("ROS_") and name not in ("PONGSIM_SECURITY", "PONGSIM_NETWORK")}
        self.environment = kept | {"PONGSIM_DOMAIN": DOMAIN, "ROS_DOMAIN_ID": DOMAIN}
        self._running = []
        self.run("security", "init", self.keys)

    def close(self):
        for process in self._running:
            process.kill()
            process.communicate()
            _running.remove(process)
        self._folder.cleanup()

    def run(self, *words, code=0, **environment):
        """Runs pongsim; returns its output if `code` is 0, else its errors. Any other exit code is a failure."""
        done = subprocess.run([PONGSIM, *map(str, words)], cwd=self.path, capture_output=True, text=True,
                              timeout=PATIENCE, env=self.environment | environment)
        assert done.returncode == code, (words, done.returncode, done.stdout[-2000:], done.stderr[-2000:])
        return done.stdout if code == 0 else done.stderr

    def start(self, *words, program=PONGSIM, **environment):
        """Starts a process: `output()` and `said()` return what it has written to standard output and error so far."""
        name = self.path / f"output{len(self._running)}"
        with open(name, "w") as output, open(f"{name}.said", "w") as said:
            process = subprocess.Popen([program, *map(str, words)], cwd=self.path, text=True, stdin=subprocess.PIPE,
                                       stdout=output, stderr=said, env=self.environment | environment)
        process.output = name.read_text
        process.said = pathlib.Path(f"{name}.said").read_text
        self._running.append(process)
        _running.append(process)
        return process

    def world(self, *words, file=WORLD, **environment):
        """Starts a world, and waits until it runs and has its topics."""
        process = self.start("run", file, *words, **environment)
        until(lambda: "step " in process.said(), "the world's start")
        return process
