"""Errors found before a sweep starts."""

from __future__ import annotations

import difflib
import importlib
from typing import Any, Iterable

from ..errors import Error


class SweepError(Error):
    """A sweep can't be run. The text has the reason, with file, line and column if the file is wrong, and a hint."""

    def __init__(self, message: str, *, at: str = "", hint: str = "") -> None:
        #: Its position: "gains.yaml:3:5"; empty if it is in no file.
        self.at = at
        super().__init__((f"{at}: error: " if at else "") + message + (f" ({hint})" if hint else ""))

    def __reduce__(self) -> tuple[object, ...]:
        return (Error, (str(self),))


def nearest(word: str, known: Iterable[str]) -> str:
    """Returns a hint: "did you mean 'values'?", or the available names."""
    names = sorted(known)
    close = difflib.get_close_matches(word, names, n=1)
    if close:
        return f"did you mean '{close[0]}'?"
    shown = ", ".join(names[:12]) + (" ..." if len(names) > 12 else "")
    return f"there is: {shown}" if names else ""


#: Names of modules' packages for pip and apt.
_PACKAGES = {
    "lxml.etree": "python3-lxml, or lxml from PyPI",
    "matplotlib": "python3-matplotlib, or matplotlib from PyPI",
    "pyarrow": "pyarrow from PyPI; not in Debian 12",
    "ray": "ray from PyPI; not in Debian 12",
    "tqdm": "python3-tqdm, or tqdm from PyPI",
    "yaml": "python3-yaml, or PyYAML from PyPI",
}


def need(module: str, purpose: str) -> Any:
    """Imports a third-party module. If it is missing, raises SweepError with what to install."""
    try:
        return importlib.import_module(module)
    except ImportError as missing:
        package = _PACKAGES.get(module, module)
        raise SweepError(f"{purpose} needs the Python module {module}: {missing}", hint=f"install {package}") from missing
