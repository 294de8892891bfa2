"""Reads a scenario's faults on purpose."""

from __future__ import annotations

import dataclasses
import functools
import json
from typing import Any, Iterable

from ..sweep.document import Node
from ..sweep.errors import nearest
from .places import schema

#: File, line and column.
_Position = tuple[str, int, int]


@dataclasses.dataclass(frozen=True)
class Faults:
    """The faults of a scenario."""

    #: The `<plugin>` of their system, as `_core.Simulation` reads it; empty without faults.
    plugins: tuple[Any, ...] = ()
    #: The topics that have faults, and where they are.
    topics: tuple[tuple[str, str], ...] = ()

    def unused(self, used: Iterable[str]) -> str:
        """Returns what is wrong if a topic with a fault is not in use: a fault that never acts is none."""
        names = list(used)
        for topic, at in self.topics:
            if topic not in names:
                return f"{at}: error: nobody in the world uses the topic {topic}, which has a fault ({nearest(topic, names)})"
        return ""


def read_faults(node: Node | None) -> Faults:
    """Reads `faults: [{type: drop, topic: /lidar, probability: 0.3}]`: what `pongsim run --fault` takes. The words are
    checked here, the values where the system reads them. Raises SweepError."""
    if node is None:
        return Faults()
    nodes = node.list("faults")
    elements = [("fault", _position(each.at), _attributes(each), ()) for each in nodes]
    place = _position(node.at)
    plugin = ("plugin", place, [("filename", "pongsim-faults-system", place), ("name", "pongsim::systems::Faults", place)], elements)
    topics = [each.value["topic"] for each in nodes if "topic" in each.value]
    return Faults((plugin,), tuple((f"/{each.value.lstrip('/')}", each.at) for each in topics))


def _attributes(node: Node) -> list[tuple[str, str, _Position]]:
    parts = node.mapping("a fault")
    kinds = _kinds()
    if "type" not in parts:
        node.fail("a fault has no 'type'", f"types are {', '.join(kinds)}")
    kind = parts["type"].text("'type' of a fault")
    if kind not in kinds:
        parts["type"].fail(f"there is no fault '{kind}'", nearest(kind, kinds))
    what = f"a fault of type '{kind}'"
    node.mapping(what, kinds[kind]["properties"])
    for key in kinds[kind]["required"]:
        if key not in parts:
            node.fail(f"{what} has no '{key}'")
    return [(key, str(value.scalar(f"'{key}' of a fault")), _position(value.at)) for key, value in parts.items()]


@functools.lru_cache(maxsize=1)
def _kinds() -> dict[str, dict[str, Any]]:
    """The published schema of each type of fault."""
    kinds = json.loads(schema().read_text(encoding="utf-8"))["$defs"]["fault"]["oneOf"]
    return {each["properties"]["type"]["const"]: each for each in kinds}


def _position(at: str) -> _Position:
    file, line, column = (at.rsplit(":", 2) + ["", ""])[:3]
    return (file, int(line), int(column)) if line.isdigit() and column.isdigit() else (at, 0, 0)
