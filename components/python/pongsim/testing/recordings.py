"""Values of a field in a recorded run, to compare with."""

from __future__ import annotations

import collections
import csv
import io
import json
import math
import pathlib
import subprocess
import sys
from typing import Any, Callable, Hashable

from ..sweep.document import Node
from ..sweep.errors import nearest
from .places import program
from .state_log import FIELDS, StateLog, States

#: Times [s] and values.
Values = tuple[list[float], list[float]]

#: Memory for numbers of recordings [bytes]: scenarios and their runs often compare with the same ones.
_MOST_KEPT = 64 << 20
#: Of a number in a list.
_BYTES_PER_NUMBER = 32


class Kept:
    """Results that are kept up to a number of bytes: beyond that, the ones that were not used for longest are forgotten."""

    def __init__(self, most: int) -> None:
        self._most = most
        self._size = 0
        self._results: collections.OrderedDict[Hashable, tuple[Any, int]] = collections.OrderedDict()

    def get(self, key: Hashable, make: Callable[[], Any], size_of: Callable[[Any], int]) -> Any:
        """Returns what is kept, or what `make` returns."""
        if key not in self._results:
            made = make()
            self._results[key] = made, size_of(made)
            self._size += self._results[key][1]
            while self._size > self._most:
                self._size -= self._results.popitem(last=False)[1][1]
            return made
        self._results.move_to_end(key)
        return self._results[key][0]


_kept = Kept(_MOST_KEPT)


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
        values: Values = _kept.get((*_version(file), name, field), lambda: _of_topic(file, name, field, node),
                                   lambda made: 2 * len(made[0]) * _BYTES_PER_NUMBER)
    else:
        values = _parse(file.read_text(encoding="utf-8", errors="replace"), file, node)
    if not values[0]:
        node.fail(f"{file} has no values of '{field}'")
    return values


def states(file: pathlib.Path, node: Node) -> tuple[States, States]:
    """Returns the states of the models and joints in a recording of `pongsim run --record-path`. Raises SweepError at the
    node."""
    place = file / "state.tlog" if file.is_dir() else file
    if not place.is_file():
        node.fail(f"there is no file {file}")
    models, joints, warning = _kept.get(_version(place), lambda: _exported(place, node), _size_of_states)
    for words in warning.splitlines():
        print(f"{node.at}: {words}", file=sys.stderr)
    if not models:
        node.fail(f"{file} has no state of a world", "pongsim run --record-path FOLDER records it")
    return models, joints


def _version(file: pathlib.Path) -> tuple[str, int, int]:
    """Returns what differs where a file is written anew."""
    status = file.stat()
    return str(file), status.st_mtime_ns, status.st_size


def _exported(file: pathlib.Path, node: Node) -> tuple[States, States, str]:
    """Returns the states, and a warning about them."""
    text, error, warning = _printed("export", str(file))
    if error and text.count("\n") < 2:
        node.fail(error)
    # of one that is cut off, and read up to there
    return *_states(text), f"warning: {error}; it is compared up to there" if error else warning


def _size_of_states(exported: tuple[States, States, str]) -> int:
    models, joints, _ = exported
    of_models, of_joints = (sum(len(times) for times, _ in found.values()) for found in (models, joints))
    return ((1 + len(FIELDS)) * of_models + 2 * of_joints) * _BYTES_PER_NUMBER


def _states(text: str) -> tuple[States, States]:
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
    found = states(file, node)[0 if kind == "pose" else 1]
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


def _of_topic(file: pathlib.Path, topic: str, field: str, node: Node) -> Values:
    text, error, _ = _printed("export", str(file), topic, field, "--csv")
    if error:
        node.fail(error)
    return _parse(text, file, node)


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


