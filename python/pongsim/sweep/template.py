"""Texts with $NAME in them, for which a parameter's value is put."""

from __future__ import annotations

import string
from typing import Any, Mapping

from .errors import SweepError


def written(value: Any) -> str:
    """A value as SDF and protobuf write it."""
    return str(value).lower() if isinstance(value, bool) else str(value)


def names(value: Any, at: str) -> list[str]:
    """All $NAMEs in a text, or in the texts of a message. Raises SweepError for a $ that names nothing."""
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
    """The value with the parameters in it. A text that is $NAME alone becomes the parameter's value itself."""
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
