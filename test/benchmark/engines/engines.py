"""The engines that are here."""

import importlib
import sys


def load():
    """The modules of all engines that can be had, ours first; says which can't."""
    found = []
    for name in ("pongsim", "mujoco", "dart", "bullet"):
        try:
            found.append(importlib.import_module(f"{name}_engine"))
        except ImportError as error:
            if name == "pongsim":
                sys.exit(f"engines benchmark: error: {error}")
            print(f"engines benchmark: {name} is left out: {error}", file=sys.stderr)
    return found
