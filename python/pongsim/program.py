"""The program `pongsim` of a wheel, in which it lies beside this file."""

from __future__ import annotations

import os
import pathlib
import sys


def main() -> int:
    """Becomes the program. What of it is in Python, as `pongsim sweep`, is run by this Python."""
    program = pathlib.Path(__file__).parent / "bin/pongsim"
    if not program.exists():
        print(f"pongsim: error: there is no {program}: this package is not a wheel", file=sys.stderr)
        return 1
    os.environ["PONGSIM_PYTHON"] = sys.executable
    os.execv(program, ["pongsim", *sys.argv[1:]])
