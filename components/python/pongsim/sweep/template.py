"""Texts with $NAME in them, which is replaced by a parameter's value."""

from __future__ import annotations

import string
from typing import Any, Mapping

from .errors import SweepError


def written(value: Any) -> str:
    """Formats a value for SDF and protobuf."""
    return str(value).lower() if isinstance(value, bool) else str(value)


def names(value: Any, at: str) -> list[str]:
    """Returns all $NAMEs in a text, or in the strings of a message. Raises SweepError for a $ without a name."""
    if isinstance(value, dict):
        return [name for each in value.values() for name in names(each, at)]
    if isinstance(value, list):
        return [name for each in value for name in names(each, at)]
    if not isinstance(value, str):
        return []
    found = []
    for match in string.Template.pattern.finditer(value):
        if match.group("invalid") is not None:
            raise SweepError(f"the $ in '{value}' is not a parameter", at=at, hint="write $$ for a $")
        name = match.group("named") or match.group("braced")
        if name:
            found.append(name)
    return found


def fill(value: Any, parameters: Mapping[str, Any]) -> Any:
    """Returns the value with the parameters inserted. A text that consists only of $NAME becomes the parameter's
    value itself."""
    if isinstance(value, dict):
        return {key: fill(each, parameters) for key, each in value.items()}
    if isinstance(value, list):
        return [fill(each, parameters) for each in value]
    if not isinstance(value, str):
        return value
    for alone in (value[1:], value[2:-1]):
        if alone in parameters and value in (f"${alone}", f"${{{alone}}}"):
            return parameters[alone]
    return string.Template(value).substitute({name: written(each) for name, each in parameters.items()})
