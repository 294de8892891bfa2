"""Starts the program `pongsim` of a wheel, which is installed next to this file."""

from __future__ import annotations

import importlib.util
import os
import pathlib
import sys


def main() -> int:
    """Replaces this process by the program. Parts written in Python, such as `pongsim sweep`, use this Python
    interpreter."""
    program = pathlib.Path(__file__).parent / "bin/pongsim"
    if not program.exists():
        # after `pip install -e`, where this file is in the source tree and what is built is not
        core = importlib.util.find_spec("pongsim._core")
        if core is not None and core.origin is not None:
            program = pathlib.Path(core.origin).parent / "bin/pongsim"
    if not program.exists():
        print(f"pongsim: error: there is no {program}: this package is not a wheel", file=sys.stderr)
        return 1
    os.environ["PONGSIM_PYTHON"] = sys.executable
    os.execv(program, ["pongsim", *sys.argv[1:]])
