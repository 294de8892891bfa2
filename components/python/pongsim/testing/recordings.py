"""Values of a field in a recorded run, to compare with."""

from __future__ import annotations

import csv
import functools
import io
import json
import math
import pathlib
import subprocess
import sys

from ..sweep.document import Node
from ..sweep.errors import nearest
from .places import program
from .state_log import FIELDS, StateLog, States

#: Times [s] and values.
Values = tuple[list[float], list[float]]


def recorded(file: pathlib.Path, signal: tuple[str, str], field: str, node: Node) -> Values:
    """Returns the values of a field in a recording of `pongsim run --record-path`, or in a file of two columns, time [s] and
    value, with a line of names: what `pongsim log export FILE TOPIC FIELD --csv` prints. Raises SweepError at the node."""
    kind, name = signal
    if file.is_dir():
        file = file / "state.tlog"
    if not file.is_file():
        node.fail(f"there is no file {file}")
    if file.suffix != ".csv":
        if kind in ("pose", "joint"):
            return _of_state(file, signal, field, node)
        if kind != "topic":
            node.fail(f"a {kind} is compared with a .csv file", "two columns: time_s and the value")
        text, error, _ = _printed("export", str(file), name, field, "--csv")
        if error:
            node.fail(error)
    else:
        text = file.read_text(encoding="utf-8", errors="replace")
    times, values = _parse(text, file, node)
    if not times:
        node.fail(f"{file} has no values of '{field}'")
    return times, values


def states(file: pathlib.Path, kind: str, node: Node) -> States:
    """Returns the states of models ("pose") or of joints in a recording of `pongsim run --record-path`. Raises SweepError at
    the node."""
    place = file / "state.tlog" if file.is_dir() else file
    if not place.is_file():
        node.fail(f"there is no file {file}")
    text, error, warning = _printed("export", str(place))
    if error and text.count("\n") < 2:
        node.fail(error)
    if kind == "pose":
        # of one that is cut off, and read up to there
        for words in (f"warning: {error}; it is compared up to there" if error else warning).splitlines():
            print(f"{node.at}: {words}", file=sys.stderr)
    found = _states(str(place), text)[0 if kind == "pose" else 1]
    if not found and kind == "pose":
        node.fail(f"{file} has no state of a world", "pongsim run --record-path FOLDER records it")
    return found


@functools.lru_cache(maxsize=8)
def _states(file: str, text: str) -> tuple[States, States]:
    log = StateLog()
    for line in text.splitlines():
        if '"type": "ignition.msgs.SerializedStateMap"' in line:
            record = json.loads(line)
            log.add(record["time_s"], record["message"])
    return log.finish()


def _of_state(file: pathlib.Path, signal: tuple[str, str], field: str, node: Node) -> Values:
    kind, name = signal
    fields = ["position"] if kind == "joint" else FIELDS
    if field not in fields:
        node.fail(f"a recording has no '{field}' of a {kind}", f"there is: {', '.join(fields)}")
    found = states(file, kind, node)
    if name not in found:
        node.fail(f"{file} has no {kind} of '{name}'", nearest(name, found))
    return values_of(found[name], fields.index(field), field)


def values_of(state: tuple[list[float], list[list[float]]], place: int, field: str) -> Values:
    """Returns the values of one field."""
    times, rows = state
    values = [row[place] for row in rows]
    # for straight lines between them, an angle does not jump by a full turn
    return times, _unwrapped(values) if field in FIELDS[3:] else values


def _unwrapped(angles: list[float]) -> list[float]:
    result: list[float] = []
    for angle in angles:
        result.append(angle if not result else result[-1] + math.remainder(angle - result[-1], 2 * math.pi))
    return result


@functools.lru_cache(maxsize=64)
def _printed(*words: str) -> tuple[str, str, str]:
    """Returns what `pongsim log` prints, its error, and its warning. With an error, it prints what comes before."""
    try:
        done = subprocess.run([program(), "log", *words], capture_output=True, text=True, stdin=subprocess.DEVNULL)
    except OSError as error:
        return "", f"{error.filename}: {error.strerror}", ""
    if done.returncode != 0:
        lines = done.stderr.strip().splitlines() or [f"pongsim log {words[0]} ended with code {done.returncode}"]
        return done.stdout, lines[0].split("error: ", 1)[-1], ""
    return done.stdout, "", done.stderr.strip().removeprefix("pongsim log: ")


def _parse(text: str, file: pathlib.Path, node: Node) -> Values:
    times: list[float] = []
    values: list[float] = []
    for number, row in enumerate(csv.reader(io.StringIO(text)), 1):
        if number == 1 or not row:
            continue
        try:
            time, value = float(row[0]), float({"true": "1", "false": "0"}.get(row[1], row[1]))
        except (ValueError, IndexError):
            node.fail(f"{file}:{number}: this is not a time and a number: {','.join(row)}")
        if not math.isfinite(time) or (times and time < times[-1]):
            node.fail(f"{file}:{number}: the times must increase")
        if times and time == times[-1]:
            values[-1] = value
            continue
        times.append(time)
        values.append(value)
    return times, values


