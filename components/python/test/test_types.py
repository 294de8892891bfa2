"""The package is typed, and the stubs of its C++ part are complete."""

import pathlib
import subprocess
import sys

import pongsim

PACKAGE = pathlib.Path(pongsim.__file__).parent

USE = """
import numpy as np
import pongsim

sim = pongsim.Simulation("w.sdf", seed=7)
x: float = sim.model("a").pose.position[0]
n: int = sim.state_hash()
ranges = sim.sensor("laser").ranges
print(ranges.mean())
b: bytes = sim.save()
"""

MISUSE = """
import pongsim

sim = pongsim.Simulation("w.sdf", sead=7)
sim.step("a")
x: str = sim.time
sim.modell("a")
"""


def mypy(*arguments):
    return subprocess.run([sys.executable, "-m", "mypy", "--cache-dir=/dev/null", *arguments], capture_output=True,
                          text=True, cwd=PACKAGE.parent)


def test_the_package_is_strictly_typed():
    result = mypy("--strict", "-p", "pongsim")
    assert result.returncode == 0, result.stdout + result.stderr


def test_a_user_is_helped(tmp_path):
    (tmp_path / "use.py").write_text(USE)
    result = mypy("--strict", str(tmp_path / "use.py"))
    assert result.returncode == 0, result.stdout + result.stderr
    (tmp_path / "misuse.py").write_text(MISUSE)
    result = mypy("--strict", str(tmp_path / "misuse.py"))
    assert result.stdout.count(": error:") == 4, result.stdout


def test_the_stubs_say_what_is_there():
    result = subprocess.run(
        [sys.executable, "-m", "mypy.stubtest", "pongsim._core", "--ignore-missing-stub", "--ignore-positional-only",
         "--allowlist", str(pathlib.Path(__file__).with_name("stubs_allowed.txt"))],
        capture_output=True, text=True, cwd=PACKAGE.parent,
    )
    assert result.returncode == 0, result.stdout + result.stderr


def test_everything_has_a_docstring():
    missing = []
    for name in pongsim.__all__:
        thing = getattr(pongsim, name)
        if name.startswith("__"):
            continue
        if not (thing.__doc__ or "").strip():
            missing.append(name)
        if isinstance(thing, type):
            for part, value in vars(thing).items():
                if not part.startswith("_") and callable(value) or isinstance(value, property):
                    if not (value.__doc__ or "").strip():
                        missing.append(f"{name}.{part}")
    assert missing == []
