"""Where the parts of pongsim are."""

from __future__ import annotations

import os
import pathlib
import shutil

_PACKAGE = pathlib.Path(__file__).resolve().parents[1]


def program() -> str:
    """Returns the program `pongsim` that belongs to this package: of the wheel, of the installation, or of the build tree;
    else the one of the PATH."""
    named = os.environ.get("PONGSIM")
    if named:
        return named
    for folder in (_PACKAGE, *_PACKAGE.parents[:4]):
        found = folder / "bin/pongsim"
        if found.is_file() and os.access(found, os.X_OK):
            return str(found)
    return shutil.which("pongsim") or "pongsim"


def schema() -> pathlib.Path:
    """Returns the JSON schema of scenarios."""
    return pathlib.Path(__file__).resolve().with_name("scenario.schema.json")
