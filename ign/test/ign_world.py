"""What the tests of ign-transport share: a world that runs, clients of Fortress, and where they meet."""

import contextlib
import os
import pathlib
import re
import signal
import subprocess
import sys
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "test/support"))

from test_domain import take_domain  # noqa: E402

PONGSIM = os.environ["PONGSIM"]
PEER = os.environ["PONGSIM_IGN_PEER"]
DRIVER = os.environ["PONGSIM_IGN_DRIVER"]
TUTORIAL = ROOT.parent / "shared/fortress/tutorials/moving_robot.sdf"
DEADLINE = 90

DOMAIN = take_domain()
ENVIRONMENT = {
    **{name: value for name, value in os.environ.items() if not name.startswith("IGN_")},
    "PONGSIM_DOMAIN": str(DOMAIN),
    # the domain is this process's alone
    "IGN_PARTITION": f"pongsim_test_{DOMAIN}_{os.getpid()}",
    "IGN_IP": "127.0.0.1",
    # the address sanitizer keeps up to 256 MB of what was freed, which is no growth of the simulation's
    "ASAN_OPTIONS": os.environ.get("ASAN_OPTIONS", "") + ":quarantine_size_mb=1",
}


def until(condition, what):
    """What the condition gives as soon as it is something."""
    end = time.monotonic() + DEADLINE
    while time.monotonic() < end:
        if value := condition():
            return value
        time.sleep(0.02)
    raise AssertionError(f"waited in vain for {what}")


def ended(*words, environment=None):
    """A command that has come to its end."""
    return subprocess.run([str(word) for word in words], env={**ENVIRONMENT, **(environment or {})},
                          capture_output=True, text=True, timeout=DEADLINE, stdin=subprocess.DEVNULL)


def run(*words, environment=None):
    """What a command says."""
    result = ended(*words, environment=environment)
    assert result.returncode == 0, f"{words}: {result.returncode}\n{result.stdout}{result.stderr}"
    return result.stdout


# How long a client of services waits [ms]: longer than a busy machine takes, shorter than the deadline.
PATIENCE = ("--timeout", "60000")

# What `ign topic` and `ign service` run. Debian 12's `ign` itself looks for them in another folder.
CLIENTS = pathlib.Path("/usr/libexec/ignition/transport11")


def client(name):
    """The program that `ign NAME` is."""
    return CLIENTS / f"ign-transport-{name}"


def ign(name, *words):
    """What Fortress's own client says. Now and then it falls over at its end (../README.md), and is asked again."""
    def result():
        client_ended = ended(client(name), *words)
        return client_ended if client_ended.returncode != -signal.SIGSEGV else None

    last = until(result, "an end without a crash")
    assert last.returncode == 0, f"{words}: {last.returncode}\n{last.stdout}{last.stderr}"
    return last.stdout


def listed(what, names):
    """What Fortress's client lists, once all of these are among it. It lists what it has been told of in a second."""
    def there():
        lines = ign(what, "-l").split()
        return lines if names <= set(lines) else None

    return until(there, f"the {what}s {', '.join(sorted(names))}")


def described(what, option, name, pattern):
    """Waits until Fortress's client says this of a topic or a service."""
    until(lambda: re.search(pattern, ign(what, "-i", option, name)), f"'{pattern}' of {name}")


class Running:
    """A program whose lines are looked at while it runs."""

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
        return until(found, f"'{pattern}' of {self.process.args}; it said: {self.text[-2000:]}")

    def finish(self):
        """Interrupts it and gives back all that it says."""
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
    """A world on ign-transport."""
    with running(PONGSIM, "run", path, "--ign", *options, environment=environment) as simulation:
        until(lambda: "/clock" in run(PONGSIM, "topic", "-l"), "the world")
        yield simulation


def resident(pid):
    """Megabytes that a process holds."""
    status = pathlib.Path(f"/proc/{pid}/status").read_text()
    return int(re.search(r"VmRSS:\s+(\d+)", status).group(1)) / 1024


def steps(world_name):
    """Steps that a world has done."""
    text = run(PONGSIM, "topic", "-e", "-t", f"/world/{world_name}/stats", "-n", "1")
    match = re.search(r"^iterations: (\d+)", text, re.MULTILINE)
    return int(match.group(1)) if match else 0


needs_ign = unittest.skipUnless(client("topic").exists(), "ignition-transport-cli is not installed")
needs_tutorial = unittest.skipUnless(TUTORIAL.exists(), f"{TUTORIAL} is not there")
