"""Memory of C++ as arrays."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._core import Memory


def view(memory: Memory, kind: str, shape: tuple[int, ...]) -> NDArray[Any]:
    """An array that looks at the memory and keeps it; to be written to where that is. `kind` is as NumPy names it: "f8"."""
    array: NDArray[Any] = np.frombuffer(memoryview(memory), np.dtype(kind)).reshape(shape)
    return array
