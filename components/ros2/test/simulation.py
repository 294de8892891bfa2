"""What tests with peers of any kind share: a running simulation in a domain of its own."""

import contextlib
import os
import pathlib
import signal
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
PONGSIM = os.environ.get("PONGSIM", str(ROOT / "build/release/bin/pongsim"))

sys.path.append(str(ROOT / "test/support"))
from test_domain import take_domain  # noqa: E402
from waiting import PATIENCE, until  # noqa: E402, F401

# inherited from the test that started this process, or a new one
DOMAIN = int(os.environ.get("PONGSIM_TEST_DOMAIN") or take_domain())
# for all processes started by the test
for name in ("PONGSIM_TEST_DOMAIN", "PONGSIM_DOMAIN", "ROS_DOMAIN_ID"):
    os.environ[name] = str(DOMAIN)


def fortress(name):
    """A file of Fortress's worlds; without them the test is skipped."""
    import pytest  # which nodes that share this file do without

    folder = pathlib.Path(os.environ.get("PONGSIM_FORTRESS_WORLDS", ROOT.parent / "shared/fortress"))
    if not (folder / name).exists():
        pytest.skip(f"no worlds of Fortress at {folder}")
    return folder / name


@contextlib.contextmanager
def running(*arguments, environment=None, log=None):
    """A simulation, `pongsim run ARGUMENTS`, which is stopped at the end. What it said is shown where the test fails,
    unless it goes to a `log` of the test's own."""
    with tempfile.TemporaryFile("w+") as own_log:
        process = subprocess.Popen([PONGSIM, "run", *map(str, arguments)], stdout=subprocess.DEVNULL,
                                   stderr=log or own_log, env={**os.environ, **(environment or {})}, text=True)
        try:
            yield process
            stop(process)
        except BaseException:
            print(f"pongsim run {' '.join(map(str, arguments))} (returned {process.poll()}):")
            own_log.seek(0)
            print(own_log.read()[-3000:])
            raise
        finally:
            if process.poll() is None:
                process.kill()
                process.wait()


def stop(process):
    if process.poll() is None:
        process.send_signal(signal.SIGINT)
        assert process.wait(PATIENCE) >= 0, "ended by a signal"
