"""Conditions on fields, as they are written in scenarios and in Python, made into what the monitor judges."""

from __future__ import annotations

import pathlib
from typing import Any

from ..sweep.document import Node
from ..sweep.errors import nearest
from .recordings import recorded

#: A criterion as the monitor reads it: field, relation, number, other, text, truth, recorded.
Criterion = dict[str, Any]

_BOUNDS = ("above", "at_least", "below", "at_most")
COMPARISONS = (*_BOUNDS, "equals", "not", "near", "between", "contains", "recorded", "tolerance")


def read_fields(node: Node, what: str, signal: tuple[str, str], folder: pathlib.Path) -> list[Criterion]:
    """Reads `{data: true, pose.position.x: {above: 1}}`; `true` alone: whatever comes. Raises SweepError.

    signal: kind and name of what the fields are of.
    folder: where recordings are.
    """
    if node.value is True:
        return []
    if not isinstance(node.value, dict) or not node.value:
        node.fail(f"{what} needs fields and their values, or true for any", "for example {data: true} or {x: {above: 1}}")
    return [each for field, value in node.mapping(what).items() for each in _read_field(field, value, signal, folder)]


def _read_field(field: str, node: Node, signal: tuple[str, str], folder: pathlib.Path) -> list[Criterion]:
    if not isinstance(node.value, dict):
        return [_equal("equals", field, node, node.scalar(f"the value of '{field}'"))]
    parts = node.value
    for key, value in parts.items():
        if key not in COMPARISONS:
            inner = f"to go into a field, write '{field}.{key}'" if not key.startswith("$") else ""
            close = nearest(key, COMPARISONS)
            value.fail(f"there is no comparison '{key}'", close if close.startswith("did") else inner or close)
    if "tolerance" in parts and not {"near", "equals", "recorded"} & parts.keys():
        parts["tolerance"].fail("'tolerance' goes with near, equals or recorded")
    made = [_read_comparison(field, key, value, parts, signal, folder) for key, value in parts.items() if key != "tolerance"]
    if not made:
        node.fail(f"'{field}' has no comparison", f"there is: {', '.join(COMPARISONS)}")
    return made


def _read_comparison(field: str, key: str, node: Node, parts: dict[str, Node], signal: tuple[str, str],
                     folder: pathlib.Path) -> Criterion:
    what = f"'{key}' of '{field}'"
    if key in _BOUNDS:
        return {"field": field, "relation": key, "number": float(node.number(what))}
    if key == "between":
        bounds = node.list(what)
        if len(bounds) != 2:
            node.fail(f"{what} has two numbers, not {len(bounds)}")
        low, high = (float(each.number(f"a bound of {what}")) for each in bounds)
        if low > high:
            node.fail(f"{what}: {low:g} is above {high:g}")
        return {"field": field, "relation": "between", "number": low, "other": high}
    if key == "contains":
        return {"field": field, "relation": "contains", "text": node.text(what)}
    tolerance = float(parts["tolerance"].number(f"'tolerance' of '{field}'", least=0)) if "tolerance" in parts else None
    if key == "recorded":
        return _read_recorded(field, node, tolerance, signal, folder)
    if key == "near" or (key == "equals" and tolerance is not None):
        if tolerance is None:
            node.fail(f"{what} needs a 'tolerance'", f"write {field}: {{near: {node.value}, tolerance: 0.1}}")
        return {"field": field, "relation": "near", "number": float(node.number(what)), "other": tolerance}
    return _equal("differs" if key == "not" else "equals", field, node, node.scalar(what))


def _equal(relation: str, field: str, node: Node, value: Any) -> Criterion:
    if isinstance(value, bool):
        return {"field": field, "relation": relation, "number": float(value), "truth": True}
    if isinstance(value, str):
        return {"field": field, "relation": relation, "text": value}
    return {"field": field, "relation": relation, "number": float(node.number(f"the value of '{field}'"))}


def _read_recorded(field: str, node: Node, tolerance: float | None, signal: tuple[str, str], folder: pathlib.Path) -> Criterion:
    if tolerance is None:
        node.fail(f"'recorded' of '{field}' needs a 'tolerance'", f"write {field}: {{recorded: {node.value}, tolerance: 0.01}}")
    values = recorded(folder / node.text(f"'recorded' of '{field}'"), signal, field, node)
    return {"field": field, "relation": "recorded", "other": tolerance, "recorded": values}
