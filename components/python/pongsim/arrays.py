"""NumPy arrays that refer to C++ memory."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._core import Memory


def view(memory: Memory, kind: str, shape: tuple[int, ...]) -> NDArray[Any]:
    """Returns an array that refers to the memory, keeps it alive, and is writable if the memory is. `kind` is
    NumPy's type: "f8"."""
    array: NDArray[Any] = np.frombuffer(memoryview(memory), np.dtype(kind)).reshape(shape)
    return array


def matrix(memory: Memory, shape: tuple[int, ...]) -> NDArray[np.float64]:
    """Returns an array of doubles that refers to the memory. Called from C++."""
    return view(memory, "f8", shape)
