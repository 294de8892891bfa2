"""Helpers for tests of ign-transport: a running world, Fortress's clients, and their partition."""

import contextlib
import os
import pathlib
import re
import signal
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "test/support"))

from test_domain import take_domain  # noqa: E402
from waiting import PATIENCE as DEADLINE, until  # noqa: E402

PONGSIM = os.environ["PONGSIM"]
PEER = os.environ["PONGSIM_IGN_PEER"]
DRIVER = os.environ["PONGSIM_IGN_DRIVER"]
TUTORIAL = ROOT.parent / "shared/fortress/tutorials/moving_robot.sdf"

DOMAIN = take_domain()
ENVIRONMENT = {
    **{name: value for name, value in os.environ.items() if not name.startswith(("IGN_", "GZ_"))},
    "PONGSIM_DOMAIN": str(DOMAIN),
    # a partition of this process's own
    "IGN_PARTITION": f"pongsim_test_{DOMAIN}_{os.getpid()}",
    "IGN_IP": "127.0.0.1",
    # the address sanitizer's quarantine, by default 256 MB of freed memory, would look like growth of the simulation
    "ASAN_OPTIONS": os.environ.get("ASAN_OPTIONS", "") + ":quarantine_size_mb=1",
}


def ended(*words, environment=None):
    """Runs a command, and returns it with exit code and output."""
    return subprocess.run([str(word) for word in words], env={**ENVIRONMENT, **(environment or {})},
                          capture_output=True, text=True, timeout=DEADLINE, stdin=subprocess.DEVNULL)


def run(*words, environment=None):
    """Runs a command that must succeed, and returns its output."""
    result = ended(*words, environment=environment)
    assert result.returncode == 0, f"{words}: {result.returncode}\n{result.stdout}{result.stderr}"
    return result.stdout


# How long a client of a service waits for the response [ms]: longer than a busy machine takes, and short enough to try
# again.
PATIENCE = ("--timeout", "20000")

# The programs behind `ign topic` and `ign service`. Debian 12's `ign` itself looks for them in another folder.
CLIENTS = pathlib.Path("/usr/libexec/ignition/transport11")


def client(name):
    """The path of the program that `ign NAME` runs."""
    return CLIENTS / f"ign-transport-{name}"


def has_crashed(result):
    """Whether a client crashed at exit, after it had done its work (../README.md)."""
    return result.returncode == -signal.SIGSEGV


def has_no_answer(result):
    """Whether a client got no response, because ign-transport lost it or the request (../README.md)."""
    return "timed out" in result.stdout + result.stderr


def ign(name, *words):
    """The output of Fortress's own client, which is run again if it crashes or gets no response."""
    def result():
        client_ended = ended(client(name), *words)
        return None if has_crashed(client_ended) or has_no_answer(client_ended) else client_ended

    last = until(result, "a client that gets an answer, and does not crash")
    assert last.returncode == 0, f"{words}: {last.returncode}\n{last.stdout}{last.stderr}"
    return last.stdout


def call_once(service, request_type, request, is_done):
    """Calls a service that must not be called twice: again only if there is no response and no effect."""
    def is_called():
        result = ended(client("service"), "-s", service, "--reqtype", request_type, "--reptype", "ignition.msgs.Boolean",
                       *PATIENCE, "--req", request)
        if has_no_answer(result):
            return is_done()
        assert has_crashed(result) or "data: true" in result.stdout, result.stdout + result.stderr
        return True

    until(is_called, f"an answer of {service}")


def listed(what, names):
    """The list of Fortress's client, once it has all of `names`. A client discovers for one second."""
    def there():
        lines = ign(what, "-l").split()
        return lines if names <= set(lines) else None

    return until(there, f"the {what}s {', '.join(sorted(names))}")


def described(what, option, name, pattern):
    """Waits until the description that Fortress's client prints of a topic or service matches the pattern."""
    until(lambda: re.search(pattern, ign(what, "-i", option, name)), f"'{pattern}' of {name}")


class Running:
    """A running program, whose output can be read at any time."""

    def __init__(self, *words, environment=None):
        self.process = subprocess.Popen([str(word) for word in words], env={**ENVIRONMENT, **(environment or {})},
                                        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        os.set_blocking(self.process.stdout.fileno(), False)
        self.text = ""

    @property
    def pid(self):
        return self.process.pid

    def output(self):
        while chunk := self.process.stdout.read():
            self.text += chunk.decode(errors="replace")
        return self.text

    def wait_for(self, pattern):
        def found():
            match = re.search(pattern, self.output(), re.MULTILINE)
            assert match or self.process.poll() is None, f"ended with {self.process.returncode}: {self.output()}"
            return match
        return until(found, lambda: f"'{pattern}' of {self.process.args}; it said: {self.text[-2000:]}")

    def finish(self):
        """Interrupts the program, and returns all of its output."""
        self.process.send_signal(signal.SIGINT)
        os.set_blocking(self.process.stdout.fileno(), True)
        rest, _ = self.process.communicate(timeout=DEADLINE)
        self.text += rest.decode(errors="replace")
        return self.text

    def end(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGCONT)
            self.process.send_signal(signal.SIGINT)
            try:
                self.process.wait(DEADLINE)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()
        self.process.stdout.close()


@contextlib.contextmanager
def running(*words, environment=None):
    program = Running(*words, environment=environment)
    try:
        yield program
    finally:
        program.end()


@contextlib.contextmanager
def world(path, *options, environment=None):
    """Runs a world with ign-transport."""
    with running(PONGSIM, "run", path, "--ign", *options, environment=environment) as simulation:
        until(lambda: "/clock" in run(PONGSIM, "topic", "-l"), "the world")
        yield simulation


def resident(pid):
    """The resident memory of a process [MB]."""
    status = pathlib.Path(f"/proc/{pid}/status").read_text()
    return int(re.search(r"VmRSS:\s+(\d+)", status).group(1)) / 1024


def steps(world_name):
    """The number of steps that a world has made."""
    text = run(PONGSIM, "topic", "-e", "-t", f"/world/{world_name}/stats", "-n", "1")
    match = re.search(r"^iterations: (\d+)", text, re.MULTILINE)
    return int(match.group(1)) if match else 0


needs_ign = unittest.skipUnless(client("topic").exists(), "ignition-transport-cli is not installed")
needs_tutorial = unittest.skipUnless(TUTORIAL.exists(), f"{TUTORIAL} is not there")
