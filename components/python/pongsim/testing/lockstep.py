"""Reads what a scenario's world waits for."""

from __future__ import annotations

from typing import Any

from .. import _core
from ..sweep.document import Node
from ..sweep.errors import nearest

_LATE = ("end", "continue")
#: Longest wait [s of wall time].
_TIMEOUT = 30.0


def read_lockstep(node: Node, has_programs: bool) -> dict[str, Any]:
    """Reads `lockstep: {topics: ["/cmd_vel:100"]}`: the options of `pongsim run --lockstep`. Returns what the monitor
    reads. Raises SweepError."""
    parts = node.mapping("lockstep", ["topics", "start", "timeout", "late"])
    if "topics" not in parts:
        node.fail("lockstep has no 'topics' to wait for", 'write lockstep: {topics: ["/cmd_vel:100"]}')
    if not has_programs:
        node.fail("'lockstep' waits for messages of programs, and the scenario has no 'programs'")
    topics = [_topic(each) for each in parts["topics"].list("'topics' of lockstep")]
    start = [_name(each) for each in parts["start"].list("'start' of lockstep")] if "start" in parts else []
    late = parts["late"].text("'late'") if "late" in parts else "end"
    if late not in _LATE:
        parts["late"].fail(f"'late' is end or continue, not '{late}'", nearest(late, _LATE))
    timeout = float(parts["timeout"].number("'timeout'", above=0)) if "timeout" in parts else _TIMEOUT
    return {"topics": topics, "start": start, "timeout": min(timeout, 1e9), "late": late}


def _topic(node: Node) -> str:
    text = node.text("a topic of lockstep")
    try:
        _core.check_lockstep_topic(text)
    except ValueError as error:
        node.fail(str(error), "a topic, and where it is not each step: TOPIC:EVERY or TOPIC:EVERY:COUNT")
    return text


def _name(node: Node) -> str:
    name = node.text("a topic of 'start'")
    wrong = _core.topic_name_error(name)
    if wrong:
        node.fail(f"'{name}' {wrong}")
    return name
