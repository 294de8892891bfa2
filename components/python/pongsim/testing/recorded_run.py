"""Reads comparisons with a whole recorded run."""

from __future__ import annotations

import dataclasses
import math
import pathlib
import sys
from typing import Any, Mapping

from ..sweep.document import Node
from ..sweep.errors import nearest
from .recordings import states, values_of
from .state_log import FIELDS, States

_TOLERANCES = ("position", "angle", "joint")
#: This near to a right angle [rad], the pitch leaves roll and yaw undetermined.
_UPRIGHT = 0.05


@dataclasses.dataclass(frozen=True)
class Part:
    """A number of a recorded run: a field of a model's pose, or the position of a joint."""

    name: str
    #: What the monitor judges: that it is as it was.
    event: dict[str, Any]
    #: When it was there [s], unless it is cut.
    begin: float
    end: float
    is_cut: bool = False


def recorded_parts(parts: Mapping[str, Node], node: Node, folder: pathlib.Path) -> list[Part]:
    """Reads what is compared: the models and joints of the recording, or what `of` names. Raises SweepError."""
    tolerances = _tolerances(parts, node)
    recording = parts["recorded"]
    file = folder / recording.text("'recorded'")
    models, joints = states(file, recording)
    names = [*models, *joints]
    if "of" in parts:
        nodes = parts["of"].list("'of'")
        names = [each.text("a name in 'of'") for each in nodes]
        for name, each in zip(names, nodes):
            if name not in models and name not in joints:
                each.fail(f"{file} has no model or joint '{name}'", nearest(name, {**models, **joints}))
    made: list[Part] = []
    for name in names:
        if name in models:
            made += _pose(name, models, tolerances, recording)
        else:
            made.append(_part("joint", name, joints, 0, "position", tolerances["joint"]))
    return made


def _tolerances(parts: Mapping[str, Node], node: Node) -> dict[str, float]:
    """Reads `tolerance: 0.01` [m and rad], or one for each kind."""
    if "tolerance" not in parts:
        node.fail("a comparison with a recorded run needs a 'tolerance'", "write tolerance: 0.001 [m, rad]")
    given = parts["tolerance"]
    if not isinstance(given.value, dict):
        return dict.fromkeys(_TOLERANCES, float(given.number("'tolerance'", least=0)))
    each = given.mapping("'tolerance'", _TOLERANCES)
    for key in _TOLERANCES:
        if key not in each:
            given.fail(f"'tolerance' has no '{key}'", "write {position: 0.001, angle: 0.01, joint: 0.01} [m, rad]")
    return {key: float(each[key].number(f"'{key}' of 'tolerance'", least=0)) for key in _TOLERANCES}


def _pose(name: str, models: States, tolerances: Mapping[str, float], recording: Node) -> list[Part]:
    times, rows = models[name]
    upright = next((time for time, row in zip(times, rows) if abs(row[4]) > math.pi / 2 - _UPRIGHT), math.inf)
    if upright < math.inf:
        print(f"{recording.at}: warning: roll and yaw of '{name}' are compared up to {upright:g} s only, where its pitch "
              "comes near to a right angle", file=sys.stderr)
    made = []
    for place, field in enumerate(FIELDS):
        part = _part("pose", name, models, place, field, tolerances["position" if place < 3 else "angle"])
        if field in ("roll", "yaw") and upright < math.inf:
            before = max([time for time in times if time < upright], default=-1.0)
            if before < times[0]:
                continue
            part = dataclasses.replace(part, end=before, is_cut=True)
        made.append(part)
    return made


def _part(kind: str, name: str, found: States, place: int, field: str, tolerance: float) -> Part:
    times, values = values_of(found[name], place, field)
    criterion = {"field": field, "relation": "recorded", "other": tolerance, "recorded": (times, values)}
    return Part(name, {"kind": kind, "name": name, "criteria": [criterion]}, times[0], times[-1])
