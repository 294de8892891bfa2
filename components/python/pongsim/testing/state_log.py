"""The state of a world in a recording: the changes of each step, in the form of Fortress's logs."""

from __future__ import annotations

import base64
import dataclasses
import struct
from typing import Any, Mapping

#: Of models or joints, by name: times [s], and as many lists of the numbers of `FIELDS`, or of a position.
States = dict[str, "tuple[list[float], list[list[float]]]"]

#: Of a pose in the world frame.
FIELDS = ["x", "y", "z", "roll", "pitch", "yaw"]


def _type(name: str) -> str:
    """The number of a component: FNV-1a of its name."""
    number = 14695981039346656037
    for letter in f"ign_gazebo_components.{name}".encode():
        number = (number ^ letter) * 1099511628211 % 2**64
    return str(number)


_NAME, _PARENT, _MODEL, _WORLD, _JOINT, _POSE, _POSITION = map(
    _type, ("Name", "ParentEntity", "Model", "World", "Joint", "Pose", "JointPosition"))


@dataclasses.dataclass
class _Entity:
    components: dict[str, bytes] = dataclasses.field(default_factory=dict)
    #: Where its numbers go; None: it has none.
    times: list[float] | None = None
    rows: list[list[float]] = dataclasses.field(default_factory=list)

    def text(self, component: str) -> str:
        return self.components.get(component, b"").decode(errors="replace")


class StateLog:
    """Poses of top-level models and positions of the first axes of joints, by time. A thing has numbers where it changes, and
    for the state before that, so that a straight line between two of them is right."""

    def __init__(self) -> None:
        self._entities: dict[str, _Entity] = {}
        self._models: States = {}
        self._joints: States = {}
        #: The time of the state before.
        self._before: float | None = None

    def add(self, time: float, message: Mapping[str, Any]) -> None:
        """Adds the changes of a step: an ignition.msgs.SerializedStateMap as JSON."""
        changed = []
        for number, given in message.get("entities", {}).items():
            if given.get("remove"):
                self._end(self._entities.pop(number, None))
                continue
            entity = self._entities.setdefault(number, _Entity())
            for each in given.get("components", {}).values():
                if each.get("remove"):
                    entity.components.pop(each["type"], None)
                else:
                    entity.components[each["type"]] = base64.b64decode(each.get("component", ""))
            changed.append(entity)
        # names of parents may come after those of their children
        for entity in changed:
            self._note(time, entity)
        self._before = time

    def finish(self) -> tuple[States, States]:
        """Returns the models and the joints."""
        for entity in self._entities.values():
            self._end(entity)
        return self._models, self._joints

    def _note(self, time: float, entity: _Entity) -> None:
        numbers = self._numbers(entity)
        if entity.times is None:
            place = self._place(entity) if numbers else None
            if place is None:
                return
            states, name = place
            entity.times, entity.rows = states.setdefault(name, ([], []))
        elif numbers == entity.rows[-1]:
            return
        else:
            self._end(entity)
        entity.times.append(time)
        entity.rows.append(numbers)

    def _end(self, entity: _Entity | None) -> None:
        """Notes what it still was in the state before."""
        if entity is not None and entity.times and self._before is not None and entity.times[-1] < self._before:
            entity.times.append(self._before)
            entity.rows.append(entity.rows[-1])

    def _numbers(self, entity: _Entity) -> list[float]:
        if _JOINT in entity.components:
            # an ignition.msgs.Double_V: a tag, the length in bytes, the numbers
            packed = entity.components.get(_POSITION, b"")
            return list(struct.unpack_from("<d", packed, 2)) if len(packed) >= 10 else []
        if _MODEL not in entity.components:
            return []
        numbers = [float(each) for each in entity.text(_POSE).split()]
        return numbers if len(numbers) == len(FIELDS) else []

    def _place(self, entity: _Entity) -> tuple[States, str] | None:
        """Where a thing belongs, and its name; None for nested models."""
        parent = self._entities.get(entity.text(_PARENT), _Entity())
        if _MODEL in entity.components:
            return (self._models, entity.text(_NAME)) if _WORLD in parent.components else None
        names = [entity.text(_NAME)]
        while _MODEL in parent.components and len(names) < 100:
            names.append(parent.text(_NAME))
            parent = self._entities.get(parent.text(_PARENT), _Entity())
        return self._joints, "::".join(reversed(names))
