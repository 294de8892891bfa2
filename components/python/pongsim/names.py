"""Names that are alike, for messages."""

from __future__ import annotations

import difflib
from typing import Iterable


def closest(name: str, known: Iterable[str]) -> str:
    """Returns "; did you mean 'x'?" for the known public name that is most like it, or that ends with it after "::", or
    nothing."""
    public = [each for each in known if not each.startswith("_")]
    found = difflib.get_close_matches(name, public, n=1, cutoff=0.75)
    if not found and name:
        found = [each for each in public if each.endswith("::" + name)]
    return f"; did you mean '{found[0]}'?" if found else ""
