"""Reads scenarios: YAML files that say what a world is to do."""

from __future__ import annotations

import dataclasses
import math
import pathlib
import re
import shlex
from xml.parsers import expat
from xml.sax.saxutils import quoteattr
from typing import Any, Mapping

from ..sweep import document, template
from ..sweep.document import Node
from ..sweep.errors import SweepError, nearest
from ..sweep.matrix import MatrixReader
from ..sweep.plan import Run, Target
from .conditions import read_fields
from .faults import Faults, read_faults
from .lockstep import read_lockstep
from .mistakes import Mistakes
from .recorded_run import recorded_parts

#: What the monitor judges: see `core/monitor.cc`.
Spec = dict[str, Any]

KEYS = ("name", "world", "duration", "parameters", "combine", "latin_hypercube", "seeds", "systems", "faults", "publish", "request",
        "programs", "lockstep", "speed", "expect", "limits", "keep")
MODES = ("eventually", "always", "never", "in_order")
SIGNALS = ("topic", "pose", "velocity", "joint", "contact")
WINDOW = ("within", "during", "at", "for", "after", "until")
KEEP: tuple[str, ...] = ("recording", "picture", "log")
#: Where parameters can be used as $NAME.
_FILLED = ("systems", "faults", "publish", "request", "programs", "lockstep", "expect")
#: Limit of wall time, in addition to what its speed asks for [s].
_WALL = 300.0
#: A larger matrix is a sweep.
MOST_RUNS = 10_000


@dataclasses.dataclass(frozen=True)
class Expected:
    """An expectation, and where it is."""

    spec: Spec
    at: str
    name: str
    #: One of several, all at the same place, of which the first that is not met is told: how it is called there.
    part: str = ""


@dataclasses.dataclass(frozen=True)
class Publication:
    """A message: when to publish it, or to call a service with it."""

    #: The topic or service.
    topic: str
    type: str
    message: Any
    #: Of a service: the type of its response; empty: it is a topic.
    reply: str
    #: Simulated time [s], or since the event.
    time: float
    #: An event after which it is published.
    after: Spec | None
    #: Repeated with this period [s] from then on; 0: once.
    every: float
    at: str


@dataclasses.dataclass(frozen=True)
class Ready:
    """When a program is ready: what it prints, publishes or subscribes to."""

    kind: str
    value: str


@dataclasses.dataclass(frozen=True)
class Program:
    """A program that runs beside the world."""

    name: str
    command: list[str]
    environment: dict[str, str]
    folder: str
    ready: Ready | None
    #: Longest wait for it [s of wall time].
    wait: float
    #: Whether it may end before the run, with code 0.
    ends: bool
    at: str


@dataclasses.dataclass(frozen=True)
class Case:
    """One run of a scenario."""

    #: Its file, and its name for people.
    file: str
    name: str
    run: Run
    world: str
    #: The world's text, with the run's parameters; None: it is the file.
    text: str | None
    #: Simulated time [s].
    duration: float
    #: Limit of wall time [s].
    wall: float
    #: Simulated seconds per second; 0: as fast as it goes.
    speed: float
    #: `<plugin>` elements in addition to those of the world.
    systems: tuple[str, ...]
    publications: tuple[Publication, ...]
    programs: tuple[Program, ...]
    faults: Faults
    #: What the monitor waits for: see `core/monitor.hh`.
    lockstep: Spec | None
    expected: tuple[Expected, ...]
    keep: tuple[str, ...]

    @property
    def label(self) -> str:
        """Its parameters and seed: "speed=0.5 seed=1"; empty for the only run."""
        return " ".join([*(f"{name}={value}" for name, value in self.run.parameters.items()), f"seed={self.run.seed}"])


@dataclasses.dataclass(frozen=True)
class Scenario:
    """A validated scenario."""

    file: str
    name: str
    cases: list[Case]


def read(source: str | pathlib.Path | Mapping[str, Any], folder: str | pathlib.Path = ".") -> Scenario:
    """Reads a scenario: a file, or its content as a dict, whose files are in `folder`. Raises SweepError with file, line
    and column."""
    if isinstance(source, Mapping):
        return _Reader(document.from_plain(dict(source), "scenario"), pathlib.Path(folder), "scenario").scenario()
    file = pathlib.Path(source)
    try:
        root = document.read(file.read_bytes().decode(), str(file), "a scenario")
    except OSError as error:
        raise SweepError(f"{file}: {error.strerror}") from None
    except UnicodeDecodeError as error:
        raise SweepError(f"it is not UTF-8 text: {error.reason}", at=str(file)) from None
    return _Reader(root, file.parent, str(file)).scenario()


class _Reader(MatrixReader):
    def __init__(self, root: Node, folder: pathlib.Path, file: str) -> None:
        super().__init__(root, root.mapping("a scenario", KEYS), folder)
        self.file = file

    def scenario(self) -> Scenario:
        """Reads and validates everything."""
        for key in ("world", "duration", "expect"):
            if key not in self.parts:
                self.root.fail(f"a scenario has no '{key}'")
        runs, target_paths = self.runs()
        if len(runs) > MOST_RUNS:
            self.root.fail(f"these are {len(runs)} runs, more than {MOST_RUNS}", "pongsim sweep makes that many")
        world, text, targets = self.read_world(target_paths)
        for part in _FILLED:
            if part in self.parts:
                self.check_names(self.parts[part].plain(), self.parts[part])
        self._check_use({path.parameter for path in target_paths})
        name = self.parts["name"].text("name") if "name" in self.parts else ""
        cases: list[Case] = []
        made: dict[str, Case] = {}
        for run in runs:
            # seeds change nothing but themselves
            key = repr(run.parameters)
            if key not in made:
                made[key] = self._case(run, name, world, text, targets)
            cases.append(dataclasses.replace(made[key], run=run))
        return Scenario(self.file, name or self.file, cases)

    def _check_use(self, used: set[str]) -> None:
        for part in _FILLED:
            if part in self.parts:
                used |= set(template.names(self.parts[part].plain(), ""))
        for name in self.names:
            if name not in used:
                self.parts["parameters"].value[name].fail(f"parameter '{name}' is not used",
                                                          f"give it an xpath, or use ${name} in a message or condition")

    def _case(self, run: Run, name: str, world: str, text: str | None, targets: tuple[Target, ...]) -> Case:
        from ..sweep import world as worlds

        parts = {key: _filled(node, run.parameters) for key, node in self.parts.items()}
        # all mistakes are told at once
        found = Mistakes()
        limits = parts["limits"].mapping("limits", ["wall"]) if "limits" in parts else {}
        programs = tuple(found.each(parts.get("programs"), "programs", lambda each: _program(each, self.folder)))
        duration = found.of(lambda: float(parts["duration"].number("duration", above=0)), 1.0)
        lockstep = found.of(lambda: read_lockstep(parts["lockstep"], "programs" in parts), None) if "lockstep" in parts else None
        expected = found.each(parts["expect"], "expect", lambda each: read_expectations(each, self.folder))
        publications = found.each(parts.get("publish"), "publish", lambda each: _message(each, self.folder))
        requests = found.each(parts.get("request"), "request", lambda each: _request(each, self.folder))
        systems = found.each(parts.get("systems"), "systems", _system)
        faults = found.of(lambda: read_faults(parts.get("faults")), Faults())
        keep: tuple[str, ...] = found.of(lambda: _keep(parts.get("keep")), KEEP)
        found.check()
        # a controller is made for a robot in real time, unless the world waits for it
        usual = 1.0 if programs and lockstep is None else 0.0
        speed = float(parts["speed"].number("speed", least=0)) if "speed" in parts else usual
        wall = _WALL + (duration / speed if speed > 0 else 0.0)
        return Case(
            file=self.file, name=name or self.file, run=run, world=world,
            text=worlds.put(text, targets, run.parameters) if text is not None else None,
            duration=duration, wall=float(limits["wall"].number("limits.wall", above=0)) if "wall" in limits else wall,
            speed=speed, systems=tuple(systems), publications=(*publications, *requests), programs=programs, faults=faults,
            lockstep=lockstep, expected=tuple(each for made in expected for each in made), keep=keep)


def _filled(node: Node, parameters: Mapping[str, Any]) -> Node:
    if isinstance(node.value, dict):
        return Node({key: _filled(each, parameters) for key, each in node.value.items()}, node.at)
    if isinstance(node.value, list):
        return Node([_filled(each, parameters) for each in node.value], node.at)
    return Node(template.fill(node.value, parameters), node.at) if isinstance(node.value, str) else node


def _signal(parts: Mapping[str, Node], node: Node, what: str) -> Spec:
    """Reads what is watched: `topic: /scan`, `contact: [robot, wall]`."""
    given = [key for key in SIGNALS if key in parts]
    if len(given) != 1:
        node.fail(f"{what} has {' and '.join(given) or 'nothing to watch'}", f"give one of {', '.join(SIGNALS)}")
    kind = given[0]
    value = parts[kind]
    if kind != "contact" or not isinstance(value.value, list):
        return {"kind": kind, "name": value.text(f"'{kind}'")}
    sides = [each.text("a side of a contact") for each in value.list("'contact'")]
    if len(sides) != 2:
        value.fail(f"a contact has two sides, not {len(sides)}", "write [robot, wall], or robot for anything it touches")
    return {"kind": kind, "name": sides[0], "other": sides[1]}


def _event(node: Node, what: str, folder: pathlib.Path) -> Spec:
    """Reads an event: `{topic: /wall/touched, is: {data: true}}`."""
    parts = node.mapping(what, [*SIGNALS, "is"])
    signal = _signal(parts, node, what)
    is_node = parts.get("is", Node(True, node.at))
    return _with_fields(signal, is_node, f"'is' of {what}", folder)


def _with_fields(signal: Spec, node: Node, what: str, folder: pathlib.Path) -> Spec:
    criteria = read_fields(node, what, (signal["kind"], signal["name"]), folder)
    if not criteria and signal["kind"] in ("pose", "velocity", "joint"):
        node.fail(f"{what} needs fields: a {signal['kind']} is always there", "for example {x: {above: 1}}"
                  if signal["kind"] != "joint" else "for example {position: {above: 1}}")
    return {**signal, "criteria": criteria}


def read_expectations(node: Node, folder: pathlib.Path) -> list[Expected]:
    """Reads an entry of `expect`: one expectation, or one for each thing of a recorded run."""
    if isinstance(node.value, dict) and "recorded" in node.value:
        return _recorded_run(node, folder)
    return [read_expectation(node, folder)]


def _recorded_run(node: Node, folder: pathlib.Path) -> list[Expected]:
    """Reads `{recorded: good, tolerance: 0.01}`: everything is where it was in a recorded run."""
    parts = node.mapping("a comparison with a recorded run", ["name", "recorded", "tolerance", "of", *WINDOW])
    for key in ("within", "at", "for", "until"):
        if key in parts:
            parts[key].fail(f"'{key}' does not go with a recorded run", "write during: [1, 3]")
    window: Spec = {"after": _event(parts["after"], "'after'", folder)} if "after" in parts else {}
    _read_window(parts, "always", window)
    name = parts["name"].text("name") if "name" in parts else ""
    made = []
    for part in recorded_parts(parts, node, folder):
        # as far as the recorded run goes; with 'after', nobody knows when it begins
        times = {} if "after" in window else {"from": max(window.get("from", 0.0), part.begin),
                                              "to": min(window.get("to", math.inf), part.end)}
        if (part.is_cut and not times) or (times and times["to"] < times["from"]):
            continue
        made.append(Expected({"mode": "always", "events": [part.event], **window, **times}, node.at, name, part.name))
    if not made:
        parts.get("during", node).fail("the recorded run has nothing at that time")
    return made


def read_expectation(node: Node, folder: pathlib.Path) -> Expected:
    """Reads an expectation."""
    parts = node.mapping("an expectation", ["name", *SIGNALS, *MODES, *WINDOW])
    modes = [key for key in MODES if key in parts]
    if len(modes) != 1:
        node.fail(f"an expectation has {' and '.join(modes) or 'none of ' + ', '.join(MODES)}", "give one of them")
    mode = modes[0]
    if mode == "in_order":
        for key in SIGNALS:
            if key in parts:
                parts[key].fail(f"'{key}' goes into the events of 'in_order'", "write in_order: [{" + key + ": ..., is: ...}, ...]")
        events = [_event(each, "an event of 'in_order'", folder) for each in parts["in_order"].list("in_order")]
    else:
        events = [_with_fields(_signal(parts, node, "an expectation"), parts[mode], f"'{mode}'", folder)]
    spec: Spec = {"mode": mode, "events": events}
    for key in ("after", "until"):
        if key in parts:
            spec[key] = _event(parts[key], f"'{key}'", folder)
    _read_window(parts, mode, spec)
    _limit_to_recording(spec)
    return Expected(spec, node.at, parts["name"].text("name") if "name" in parts else "")


def _read_window(parts: Mapping[str, Node], mode: str, spec: Spec) -> None:
    given = [key for key in ("within", "during", "at") if key in parts]
    if len(given) > 1:
        parts[given[1]].fail(f"an expectation has {' and '.join(given)}", "give one of them")
    if "at" in parts and mode != "always":
        parts["at"].fail("'at' goes with 'always'", "write always: ..., at: 3; or 'during' or 'within'")
    if "within" in parts and mode in ("always", "never") and "until" not in parts:
        parts["within"].fail(f"'within' does not go with '{mode}'", "write during: [0, 3]; or until: ... for its end")
    if "until" in parts and mode not in ("always", "never"):
        parts["until"].fail("'until' goes with 'always' or 'never'")
    if "for" in parts:
        if mode != "eventually":
            parts["for"].fail("'for' goes with 'eventually'", "write during: [0, 3]")
        spec["hold"] = float(parts["for"].number("for", above=0))
    if "within" in parts:
        spec["to"] = float(parts["within"].number("within", above=0))
    elif "at" in parts:
        spec["from"] = spec["to"] = float(parts["at"].number("at", least=0))
    elif "during" in parts:
        bounds = [float(each.number("a time of 'during'", least=0)) for each in parts["during"].list("during")]
        if len(bounds) not in (1, 2) or sorted(bounds) != bounds:
            parts["during"].fail("'during' is [from, to], or [from] for the rest of the run")
        spec["from"] = bounds[0]
        if len(bounds) == 2:
            spec["to"] = bounds[1]


def _limit_to_recording(spec: Spec) -> None:
    """Without a window, a comparison goes as far as the recorded run does."""
    if "to" in spec or "after" in spec or "until" in spec:
        return
    ranges = [each["recorded"][0] for event in spec["events"] for each in event["criteria"] if "recorded" in each]
    if ranges:
        spec["from"] = max(times[0] for times in ranges)
        spec["to"] = max(spec["from"], min(times[-1] for times in ranges))


def _system(node: Node) -> str:
    """Reads a system that is added to the world: its `<plugin>` element, in one line."""
    parts = node.mapping("a system", ["filename", "name", "xml"])
    for key in ("filename", "name"):
        if key not in parts:
            node.fail(f"a system has no '{key}'", "write its <plugin>'s attributes: filename: ..., name: ...")
    inner = " ".join(parts["xml"].text("'xml'").split()) if "xml" in parts else ""
    filename, name = (quoteattr(parts[key].text(f"'{key}'")) for key in ("filename", "name"))
    element = f"<plugin filename={filename} name={name}>{inner}</plugin>"
    try:
        expat.ParserCreate().Parse(element, True)
    except expat.ExpatError as error:
        parts.get("xml", node).fail(f"'xml' is not the inside of a <plugin>: {expat.errors.messages[error.code]}")
    return element


def _message(node: Node, folder: pathlib.Path) -> Publication:
    parts = node.mapping("a message to publish", ["topic", "type", "message", "at", "after", "every"])
    return _publication(node, parts, "a message to publish", "topic", "", folder)


def _request(node: Node, folder: pathlib.Path) -> Publication:
    parts = node.mapping("a request", ["service", "type", "message", "reply", "at", "after", "every"])
    if "type" not in parts:
        node.fail("a request has no 'type'", "for example type: EntityFactory")
    reply = parts["reply"].text("reply") if "reply" in parts else "Boolean"
    return _publication(node, parts, "a request", "service", reply, folder)


def _publication(node: Node, parts: Mapping[str, Node], what: str, place: str, reply: str, folder: pathlib.Path) -> Publication:
    for key in (place, "message"):
        if key not in parts:
            node.fail(f"{what} has no '{key}'")
    message = parts["message"].plain()
    if not isinstance(message, (dict, str)):
        parts["message"].fail("a message must be a mapping of its fields, or protobuf text")
    return Publication(
        parts[place].text(place), parts["type"].text("type") if "type" in parts else "", message, reply,
        float(parts["at"].number("at", least=0)) if "at" in parts else 0.0,
        _event(parts["after"], "'after'", folder) if "after" in parts else None,
        float(parts["every"].number("every", above=0)) if "every" in parts else 0.0, node.at)


def _program(node: Node, folder: pathlib.Path) -> Program:
    parts = node.mapping("a program", ["name", "command", "environment", "folder", "ready", "wait", "ends"])
    if "command" not in parts:
        node.fail("a program has no 'command'")
    command = _command(parts["command"])
    environment = parts["environment"].mapping("environment") if "environment" in parts else {}
    ends = parts["ends"].value if "ends" in parts else False
    if not isinstance(ends, bool):
        parts["ends"].fail("'ends' must be true or false")
    return Program(
        parts["name"].text("name") if "name" in parts else pathlib.Path(command[0]).name, command,
        {key: str(value.scalar(f"'{key}' of the environment")) for key, value in environment.items()},
        str(folder / (parts["folder"].text("folder") if "folder" in parts else ".")),
        _ready(parts["ready"]) if "ready" in parts else None,
        float(parts["wait"].number("wait", above=0)) if "wait" in parts else 30.0, ends, node.at)


def _command(node: Node) -> list[str]:
    if isinstance(node.value, list):
        return [str(each.scalar("a word of a command")) for each in node.list("command")]
    try:
        words = shlex.split(node.text("command"))
    except ValueError as error:
        node.fail(f"the command '{node.value}': {error}")
    if not words:
        node.fail("the command is empty")
    return words


def _ready(node: Node) -> Ready:
    parts = node.mapping("ready", ["prints", "publishes", "subscribes"])
    if len(parts) != 1:
        node.fail("ready needs one of prints, publishes, subscribes", "write ready: {publishes: /cmd_vel}")
    [(kind, value)] = parts.items()
    text = value.text(f"'{kind}'")
    if kind == "prints":
        try:
            re.compile(text)
        except re.error as error:
            value.fail(f"'{text}' is not a regular expression: {error}")
    return Ready(kind, text)


def _keep(node: Node | None) -> tuple[str, ...]:
    if node is None:
        return KEEP
    if node.value == []:
        return ()
    words = [each.text("a word of 'keep'") for each in node.list("keep")]
    for word, each in zip(words, node.value):
        if word not in KEEP:
            each.fail(f"there is no '{word}' to keep", nearest(word, KEEP))
    return tuple(words)
