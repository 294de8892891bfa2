"""What systems in Python save, as bytes: plain values in JSON. Reading them runs no code, whoever has made them."""

from __future__ import annotations

import base64
import json
from collections.abc import Callable
from typing import Any

import numpy as np

from .values import Pose

_KINDS = (
    "None, bool, int, float, complex, str, bytes, list, tuple, dict, set, frozenset, pongsim.Pose, or a number or an array "
    "of numbers of NumPy"
)

# booleans, integers, floating-point and complex numbers, times and differences of times; no objects
_ARRAY_KINDS = "biufcmM"

# what has no form of its own in JSON is an object with one key, the name of its kind
_MEANINGS: dict[str, Callable[[Any], Any]] = {
    "tuple": lambda items: tuple(map(_meaning, items)),
    "dict": lambda items: {_meaning(key): _meaning(value) for key, value in items},
    "set": lambda items: set(map(_meaning, items)),
    "frozenset": lambda items: frozenset(map(_meaning, items)),
    "bytes": lambda text: base64.b64decode(text, validate=True),
    "complex": lambda parts: complex(*map(float, parts)),
    "Pose": lambda parts: _pose(*parts),
    "array": lambda parts: _array(*parts),
    "number": lambda parts: _array(*parts)[()],
}


def encode(value: Any, owner: str) -> bytes:
    """`owner` is the class whose `save` has returned the value. Raises TypeError for a value of another kind, with its
    type and place, and ValueError for one that is in itself."""
    try:
        return json.dumps(_form(value, "")).encode()
    except TypeError as error:
        raise TypeError(f"{owner}.save has returned what can't be saved: {error}") from None
    except RecursionError:
        raise ValueError(f"{owner}.save has returned what is nested too deeply, or in itself") from None


def decode(data: bytes) -> Any:
    """Raises ValueError for bytes that `encode` does not make."""
    try:
        return _meaning(json.loads(data))
    except (ValueError, TypeError, KeyError, RecursionError, OverflowError) as error:
        raise ValueError(f"it is not what a system has saved: {error}") from error


def _form(value: Any, place: str) -> Any:
    kind = type(value)
    if value is None or kind in (bool, int, float, str):
        return value
    if kind is list:
        return [_form(item, f"{place}[{i}]") for i, item in enumerate(value)]
    if kind in (tuple, set, frozenset):
        return {kind.__name__: [_form(item, f"{place}[{i}]") for i, item in enumerate(value)]}
    if kind is dict:
        return {"dict": [[_form(key, place), _form(item, f"{place}[{key!r}]")] for key, item in value.items()]}
    if kind is bytes:
        return {"bytes": base64.b64encode(value).decode()}
    if kind is complex:
        return {"complex": [value.real, value.imag]}
    if kind is Pose:
        return {"Pose": [list(map(float, part)) for part in value]}
    if (kind is np.ndarray or isinstance(value, np.generic)) and value.dtype.kind in _ARRAY_KINDS:
        return {"array" if kind is np.ndarray else "number": [
            value.dtype.str, list(value.shape), base64.b64encode(value.tobytes()).decode()]}
    name = kind.__name__ if kind.__module__ == "builtins" else f"{kind.__module__}.{kind.__qualname__}"
    if isinstance(value, (np.ndarray, np.generic)):
        name += f" of {value.dtype}"
    raise TypeError(f"{place or 'it'} is of type {name}; it can be {_KINDS}")


def _meaning(form: Any) -> Any:
    if type(form) is list:
        return [_meaning(item) for item in form]
    if type(form) is not dict:
        return form
    (kind, content), = form.items()
    return _MEANINGS[kind](content)


def _pose(position: list[float], orientation: list[float]) -> Pose:
    x, y, z = map(float, position)
    i, j, k, w = map(float, orientation)
    return Pose((x, y, z), (i, j, k, w))


def _array(kind: str, shape: list[int], content: str) -> Any:
    dtype = np.dtype(str(kind))
    if dtype.kind not in _ARRAY_KINDS:
        raise ValueError(f"an array can't be of {dtype}")
    return np.frombuffer(base64.b64decode(content, validate=True), dtype).reshape(shape).copy()
