"""Writes a first scenario for a world: `pongsim test --init world.sdf`."""

from __future__ import annotations

import dataclasses
import functools
import math
import os
import pathlib
import sys
import warnings
from typing import Any

from ..errors import LoadError, WorldWarning
from ..simulation import Simulation
from ..sweep.errors import SweepError
from ..worlds import find
from . import places
from .execute import execute
from .result import Status
from .scenario import Case, read

#: Length of the scenario, and when the robot is told to drive [s].
_DURATION, _COMMAND_AT = 3.0, 0.5
_SAMPLE = 0.02
#: More would be no first scenario.
_MOST_MODELS, _MOST_TOPICS = 4, 4
#: What a model must move to count as moving [m], and how far it may leave what was seen.
_MOVES, _MARGIN = 0.05, 0.05
#: Topics that all worlds have, and those whose subscribers make it render.
_COMMON = ("/clock", "/stats", "/world/", "/gazebo/")
_RENDERED = ("Image", "PointCloudPacked", "CameraInfo")


@dataclasses.dataclass
class _Seen:
    """What a world does by itself, or after a command."""

    command: str = ""
    #: For each model its lowest and highest x, y, z, and the last.
    ranges: dict[str, list[tuple[float, float, float]]] = dataclasses.field(default_factory=dict)
    #: The time of the first message of each topic [s].
    topics: dict[str, float] = dataclasses.field(default_factory=dict)


def write_first(world: str, output: str | None) -> int:
    """Writes the scenario, and says so. Returns the exit code."""
    name = find(world)
    path = pathlib.Path(output) if output is not None else pathlib.Path(pathlib.Path(world).name).with_suffix(".yaml")
    if not os.path.isfile(name):
        raise SweepError(f"there is no file {world}")
    if path.exists():
        raise SweepError(f"{path} is there already", hint="-o names another file")
    try:
        seen = _watch(name)
    except LoadError as error:
        print("\n".join(str(each) for each in error.diagnostics if each.is_error), file=sys.stderr)
        return 1
    entries = _expectations(seen)
    if not entries:
        raise SweepError(f"{world} has no model and no topic to expect something of")
    placed = world if name != world and not os.path.exists(world) else _from(path.parent, name)
    content: dict[str, Any] = {"world": placed, "duration": _DURATION, "expect": [entry for _, entry in entries]}
    if seen.command:
        content["publish"] = [{"topic": seen.command, "at": _COMMAND_AT, "message": {"linear": {"x": 0.5}}}]
    [case] = read(content, path.parent).cases
    entries = _those_met(case, entries)
    path.write_text(_text(path, placed, seen.command, entries), encoding="utf-8")
    print(f"{path}: {len(entries)} expectations; run it with: pongsim test {path}")
    return 0


def _from(folder: pathlib.Path, file: str) -> str:
    """Returns the way to a file: from the folder if it is near."""
    way = os.path.relpath(file, folder)
    return os.path.abspath(file) if way.startswith(os.path.join(*[os.pardir] * 3)) else way


def _watch(name: str) -> _Seen:
    """Runs the world, and tells it to drive if it can."""
    seen = _Seen()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", WorldWarning)
        sim = Simulation(name)
    with sim:
        topics = sim.topics
        commands = sorted((each for each, type in topics.items() if type == "ignition.msgs.Twist"),
                          key=lambda each: ("cmd_vel" not in each, each))
        seen.command = commands[0] if commands else ""
        for topic, type in topics.items():
            if not topic.startswith(_COMMON) and type.rpartition(".")[2] not in _RENDERED and topic != seen.command:
                sim.subscribe(topic, functools.partial(_note, seen, sim, topic), type=bytes)
        models = [each for each in sim.models if not each.is_static] or sim.models[:1]
        places_of: dict[str, list[tuple[float, ...]]] = {each.name: [each.pose.position] for each in models}
        for i in range(1, round(_DURATION / _SAMPLE) + 1):
            if seen.command and math.isclose((i - 1) * _SAMPLE, _COMMAND_AT):
                sim.publish(seen.command, {"linear": {"x": 0.5}})
            sim.run_until(i * _SAMPLE)
            for model in models:
                if model.exists:
                    places_of[model.name].append(model.pose.position)
        for model_name, positions in places_of.items():
            seen.ranges[model_name] = [(min(axis), max(axis), axis[-1]) for axis in zip(*positions)]
    return seen


def _note(seen: _Seen, sim: Simulation, topic: str, message: bytes) -> None:
    seen.topics.setdefault(topic, sim.time)


def _rounded(value: float) -> float:
    return float(f"{value:.3g}")


def _expectations(seen: _Seen) -> list[tuple[str, dict[str, Any]]]:
    """Returns the entries of `expect`, each with a comment."""
    entries: list[tuple[str, dict[str, Any]]] = []
    for model, ranges in list(seen.ranges.items())[:_MOST_MODELS]:
        for axis, (low, high, last) in zip("xy", ranges[:2]):
            first = low if last > (low + high) / 2 else high
            if high - low > _MOVES:
                way = {"above" if last > first else "below": _rounded((first + last) / 2)}
                entries.append((f"{model} moves", {"pose": model, "eventually": {axis: way}, "within": _DURATION}))
        low, high, _ = ranges[2]
        entries.append((f"{model} neither falls nor flies away",
                        {"pose": model, "always": {"z": {"between": [_rounded(low - _MARGIN), _rounded(high + _MARGIN)]}}}))
    for topic, first_time in sorted(seen.topics.items())[:_MOST_TOPICS]:
        entries.append((f"{topic} has messages", {"topic": topic, "eventually": True, "within": min(_DURATION, math.ceil(first_time + 0.5))}))
    return entries


def _those_met(case: Case, entries: list[tuple[str, dict[str, Any]]]) -> list[tuple[str, dict[str, Any]]]:
    """Returns the entries that a run meets. Raises SweepError if it fails for another reason."""
    result = execute(case)
    if result.status is Status.MISTAKE or not result.judged:
        raise SweepError(result.reason or "the world does not run")
    met = [entry for entry, judged in zip(entries, result.judged) if judged.met]
    if not met:
        raise SweepError("nothing of what the world did once was so again")
    return met


def _text(path: pathlib.Path, world: str, command: str, entries: list[tuple[str, dict[str, Any]]]) -> str:
    lines = [f"# yaml-language-server: $schema={places.schema()}", f"# Run it with: pongsim test {path.name}",
             f"world: {_scalar(world)}", f"duration: {_DURATION:g}    # simulated seconds at most"]
    if command:
        lines += ["publish:", f"  - topic: {_scalar(command)}", f"    at: {_COMMAND_AT:g}", "    message: {linear: {x: 0.5}}"]
    lines.append("expect:")
    for comment, entry in entries:
        lines.append(f"  # {comment}")
        for i, (key, value) in enumerate(entry.items()):
            lines.append(f"  {'-' if i == 0 else ' '} {key}: {_flow(value)}")
    return "\n".join(lines) + "\n"


def _flow(value: Any) -> str:
    if isinstance(value, dict):
        return "{" + ", ".join(f"{key}: {_flow(each)}" for key, each in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(_flow(each) for each in value) + "]"
    if isinstance(value, bool):
        return str(value).lower()
    return f"{value:g}" if isinstance(value, (int, float)) else _scalar(value)


def _scalar(text: str) -> str:
    plain = text and all(each.isalnum() or each in "_./-" or each == ":" for each in text) and not text.endswith(":")
    return text if plain and not text.startswith("-") else "'" + text.replace("'", "''") + "'"
