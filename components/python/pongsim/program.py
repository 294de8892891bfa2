"""Starts the program `pongsim` of a wheel, which is installed next to this file."""

from __future__ import annotations

import os
import pathlib
import sys


def main() -> int:
    """Replaces this process by the program. Parts written in Python, such as `pongsim sweep`, use this Python
    interpreter."""
    program = pathlib.Path(__file__).parent / "bin/pongsim"
    if not program.exists():
        print(f"pongsim: error: there is no {program}: this package is not a wheel", file=sys.stderr)
        return 1
    os.environ["PONGSIM_PYTHON"] = sys.executable
    os.execv(program, ["pongsim", *sys.argv[1:]])
