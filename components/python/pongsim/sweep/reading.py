"""Reads a sweep's file into a plan and its runs."""

from __future__ import annotations

import ast
import dataclasses
import hashlib
import json
import os
import pathlib
from typing import Any, Mapping, Union

from .. import _core
from . import document, template, world
from .document import Node
from .errors import SweepError, nearest
from .matrix import MatrixReader
from .plan import TAKES, Command, Condition, Function, Measure, Plan, Run, Until

#: A sweep: its file, or the file's content as a dict.
Source = Union[str, "os.PathLike[str]", Mapping[str, Any]]

_KEYS = ("world", "duration", "until", "limits", "parameters", "combine", "latin_hypercube", "seeds", "commands", "setup",
         "measures", "fresh")
_CONDITION = ("above", "below", "equals")
#: Columns that the results have anyway.
RESERVED = ("run", "seed", "status", "reason", "state_hash", "sim_time", "wall_time")


@dataclasses.dataclass(frozen=True)
class Sweep:
    """A validated sweep."""

    plan: Plan
    runs: list[Run]
    #: The file it was read from; None: a dict.
    file: pathlib.Path | None
    #: What must not change before it is finished: names and digests.
    digests: dict[str, str]


def read(source: Source) -> Sweep:
    """Reads a sweep. Raises SweepError with file, line and column."""
    if isinstance(source, Mapping):
        text = json.dumps(source, sort_keys=True, default=str)
        return _Reader(document.from_plain(dict(source), "sweep"), None).sweep(text.encode())
    file = pathlib.Path(source)
    try:
        data = file.read_bytes()
        root = document.read(data.decode(), str(file))
    except OSError as error:
        raise SweepError(f"{file}: {error.strerror}") from None
    except UnicodeDecodeError as error:
        raise SweepError(f"it is not UTF-8 text: {error.reason}", at=str(file)) from None
    return _Reader(root, file).sweep(data)


class _Reader(MatrixReader):
    reserved = RESERVED

    def __init__(self, root: Node, file: pathlib.Path | None) -> None:
        super().__init__(root, root.mapping("a sweep", _KEYS), file.parent if file is not None else pathlib.Path("."))
        self.file = file
        self.sources: dict[str, str] = {}
        #: Paths of the Python files, by their names in the sweep's file.
        self.judges: dict[str, str] = {}

    def sweep(self, data: bytes) -> Sweep:
        """Reads and validates everything."""
        for key in ("world", "measures"):
            if key not in self.parts:
                self.root.fail(f"a sweep has no '{key}'")
        runs, target_paths = self.runs()
        plan = self._plan(target_paths)
        self._check_use(plan, target_paths)
        digests = {self.file.name if self.file is not None else "the sweep": _digest(data)}
        digests[self.parts["world"].value] = _digest(pathlib.Path(plan.world).read_bytes())
        # by their names in the file, whatever folder it is read from
        for name, path in self.judges.items():
            digests[name] = _digest(self.sources[path].encode())
        digests["pongsim"] = plan.version
        plan = dataclasses.replace(plan, key=_digest(json.dumps(digests, sort_keys=True).encode()))
        return Sweep(plan, runs, self.file, digests)

    def _plan(self, target_paths: list[world.TargetPath]) -> Plan:
        path, text, targets = self.read_world(target_paths)
        duration, until = self._end()
        limits = self._limits()
        return Plan(
            key="", version=_core.version, world=path, text=text,
            targets=targets, commands=self._commands(),
            measures=self._measures(),
            setup=self._function("", self.parts["setup"]) if "setup" in self.parts else None,
            duration=limits["simulated"].number("limits.simulated", above=0) if until is not None else duration,
            until=until,
            wall_limit=limits["wall"].number("limits.wall", above=0) if "wall" in limits else 3600.0,
            fresh=self._flag("fresh"), sources=self.sources,
        )

    def _limits(self) -> dict[str, Node]:
        limits = self.parts["limits"].mapping("limits", ["simulated", "wall"]) if "limits" in self.parts else {}
        if "until" in self.parts and "simulated" not in limits:
            self.parts["until"].fail("a run with 'until' needs limits.simulated", "write limits: {simulated: 60}")
        if "until" not in self.parts and "simulated" in limits:
            limits["simulated"].fail("limits.simulated needs 'until'; a run with 'duration' ends by itself")
        return limits

    def _end(self) -> tuple[float, Until | None]:
        if ("duration" in self.parts) == ("until" in self.parts):
            self.root.fail("a sweep needs either 'duration' or 'until'", "for example duration: 10, in simulated seconds")
        if "duration" in self.parts:
            return self.parts["duration"].number("duration", least=0), None
        node = self.parts["until"]
        parts = node.mapping("until", ["topic", "field", *_CONDITION])
        condition = _condition(node, parts)
        if condition is None or "topic" not in parts or "field" not in parts:
            node.fail("until needs a topic, a field, and one of above, below, equals")
        return 0.0, Until(parts["topic"].text("topic"), parts["field"].text("field"), condition)

    def _flag(self, name: str) -> bool:
        if name not in self.parts:
            return False
        value = self.parts[name].value
        if not isinstance(value, bool):
            self.parts[name].fail(f"{name} must be true or false")
        return value

    def _commands(self) -> tuple[Command, ...]:
        if "commands" not in self.parts:
            return ()
        commands = []
        for node in self.parts["commands"].list("commands"):
            parts = node.mapping("a command", ["topic", "type", "at", "message"])
            for key in ("topic", "message"):
                if key not in parts:
                    node.fail(f"a command has no '{key}'")
            message = parts["message"].plain()
            if not isinstance(message, (dict, str)):
                parts["message"].fail("a message must be a mapping of its fields, or protobuf text")
            self.check_names(message, parts["message"])
            commands.append(Command(
                parts["topic"].text("topic"), parts["type"].text("type") if "type" in parts else "",
                parts["at"].number("at", least=0) if "at" in parts else 0.0, message))
        return tuple(sorted(commands, key=lambda each: each.time))

    def _measures(self) -> tuple[Measure | Function, ...]:
        measures: list[Measure | Function] = []
        for name, node in self.parts["measures"].mapping("measures").items():
            if not name.isidentifier() or name in RESERVED or name in self.names:
                node.fail(f"'{name}' can't be the name of a measure",
                          "use letters, digits and _; no parameter's name, and not " + ", ".join(RESERVED))
            parts = node.mapping(f"measure '{name}'", ["function", "topic", "field", "take", *_CONDITION])
            if "function" in parts:
                if len(parts) > 1:
                    node.fail(f"measure '{name}' needs either a function or a topic, not both")
                measures.append(self._function(name, parts["function"]))
            else:
                measures.append(_measure(name, node, parts))
        if not measures:
            self.parts["measures"].fail("the sweep has no measures")
        return tuple(measures)

    def _function(self, name: str, node: Node) -> Function:
        file, colon, function = node.text("a function").rpartition(":")
        if not colon or not file or not function.isidentifier():
            node.fail(f"'{node.value}' is not a function", "write judge.py:score")
        path = str(self.folder / file)
        try:
            text = pathlib.Path(path).read_text()
            tree = ast.parse(text, path)
        except OSError as error:
            node.fail(f"{path}: {error.strerror}")
        except (SyntaxError, ValueError) as error:
            line = getattr(error, "lineno", None)
            raise SweepError(str(getattr(error, "msg", error)), at=f"{path}:{line}" if line else path) from None
        defined = {each.name for each in tree.body if isinstance(each, (ast.FunctionDef, ast.ClassDef))}
        assigned = {each.id for each in ast.walk(tree) if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Store)}
        imported = {alias.asname or alias.name for each in tree.body if isinstance(each, (ast.Import, ast.ImportFrom))
                    for alias in each.names}
        if function not in defined | assigned | imported:
            node.fail(f"{path} has no function '{function}'", nearest(function, defined))
        self.sources[path] = text
        self.judges[file] = path
        return Function(name, path, function)

    def _check_use(self, plan: Plan, target_paths: list[world.TargetPath]) -> None:
        if plan.setup is not None or any(isinstance(each, Function) for each in plan.measures):
            return
        used = {way.parameter for way in target_paths}
        for way in target_paths:
            used |= set(template.names(way.text, way.at))
        for command in plan.commands:
            used |= set(template.names(command.message, ""))
        for name in self.names:
            if name not in used:
                self.parts["parameters"].value[name].fail(
                    f"parameter '{name}' is not used", f"give it an xpath, or use ${name} in a command")


def _condition(node: Node, parts: Mapping[str, Node]) -> Condition | None:
    if not any(key in parts for key in _CONDITION):
        return None
    return Condition(
        parts["above"].number("above") if "above" in parts else None,
        parts["below"].number("below") if "below" in parts else None,
        parts["equals"].scalar("equals") if "equals" in parts else None,
    )


def _measure(name: str, node: Node, parts: Mapping[str, Node]) -> Measure:
    if "topic" not in parts:
        node.fail(f"measure '{name}' has no 'topic' and no 'function'")
    take = parts["take"].text("take") if "take" in parts else "last"
    if take not in TAKES:
        parts["take"].fail(f"there is no '{take}' to take", nearest(take, TAKES))
    condition = _condition(node, parts)
    if take == "time" and condition is None:
        node.fail(f"measure '{name}' needs a condition for the time", "one of above, below, equals")
    if condition is not None and take not in ("time", "count"):
        node.fail(f"measure '{name}': a condition is only for time and count, not for {take}")
    if "field" not in parts and (take != "count" or condition is not None):
        node.fail(f"measure '{name}' has no 'field'")
    field = parts["field"].text("field") if "field" in parts else ""
    return Measure(name, parts["topic"].text("topic"), field, take, condition)


def _digest(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()
