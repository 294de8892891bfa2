"""Values of a field in a recorded run, to compare with."""

from __future__ import annotations

import csv
import functools
import io
import math
import pathlib
import subprocess

from ..sweep.document import Node
from .places import program

#: Times [s] and values.
Values = tuple[list[float], list[float]]


def recorded(file: pathlib.Path, signal: tuple[str, str], field: str, node: Node) -> Values:
    """Returns the values of a topic's field in a recording of `pongsim run --record-path`, or in a file of two columns,
    time [s] and value, with a line of names: what `pongsim log export FILE TOPIC FIELD --csv` prints. Raises SweepError at
    the node."""
    if file.is_dir():
        file = file / "state.tlog"
    if not file.is_file():
        node.fail(f"there is no file {file}")
    if file.suffix != ".csv":
        kind, topic = signal
        if kind != "topic":
            node.fail(f"a {kind} is compared with a .csv file", "two columns: time_s and the value")
        text, error = _exported(str(file), topic, field)
        if error:
            node.fail(error)
    else:
        text = file.read_text(encoding="utf-8", errors="replace")
    times, values = _parse(text, file, node)
    if not times:
        node.fail(f"{file} has no values of '{field}'")
    return times, values


@functools.lru_cache(maxsize=64)
def _exported(file: str, topic: str, field: str) -> tuple[str, str]:
    """Returns what `pongsim log export` prints, and its error."""
    try:
        done = subprocess.run([program(), "log", "export", file, topic, field, "--csv"], capture_output=True, text=True,
                              stdin=subprocess.DEVNULL)
    except OSError as error:
        return "", f"{error.filename}: {error.strerror}"
    if done.returncode != 0:
        lines = done.stderr.strip().splitlines() or [f"pongsim log export ended with code {done.returncode}"]
        return "", lines[0].removeprefix("pongsim log: error: ").removeprefix("pongsim log export: error: ")
    return done.stdout, ""


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


