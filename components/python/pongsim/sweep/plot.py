"""Plots of a sweep: each measure over each parameter."""

from __future__ import annotations

import collections
import math
import os
import pathlib
import statistics
from typing import Sequence

from .errors import SweepError, nearest, need
from .results import read

#: With at most this many different values, a line joins the means.
_MOST_MEANS = 60
#: Width and height of one plot [inches].
_SIZE = (4.0, 3.0)


def plot(
    folder: str | os.PathLike[str],
    output: str | os.PathLike[str] | None = None,
    *,
    x: Sequence[str] = (),
    y: Sequence[str] = (),
) -> pathlib.Path:
    """Plots the successful runs: one plot for each measure and parameter with numeric values, with one dot per run, and
    the mean if several runs share a value.

    folder: the folder of the sweep's results, or its results.csv.
    output: the file, whose extension sets the format: .png, .svg, .pdf; None: plot.png in the folder.
    x, y: only these parameters and measures.

    Returns the file. Raises SweepError.
    """
    place = pathlib.Path(folder)
    columns, rows = read(place)
    done = [row for row in rows if row["status"] == "done"]
    if not done:
        raise SweepError(f"{place} has no completed run")
    seed = columns.index("seed")
    numbers = {name: values for name in columns if (values := _numbers([row[name] for row in done])) is not None}
    across = _chosen(x, [name for name in columns[1:seed + 1] if name in numbers], "parameter", columns)
    up = _chosen(y, [name for name in columns[seed + 1:columns.index("status")] if name in numbers], "measure", columns)
    if not x:
        varied = [name for name in across if len(set(numbers[name])) > 1]
        across = [name for name in varied if name != "seed"] or varied or across[:1]
    if not across or not up:
        raise SweepError(f"{place} has no numeric measure and parameter")
    path = pathlib.Path(output) if output is not None else (place if place.is_dir() else place.parent) / "plot.png"
    _draw(path, {name: numbers[name] for name in across}, {name: numbers[name] for name in up})
    return path


def _numbers(texts: list[str]) -> list[float] | None:
    """Converts texts to numbers, with NaN for empty ones; None if they are not numeric."""
    try:
        values = [float({"": "nan", "true": "1", "false": "0"}.get(text, text)) for text in texts]
    except ValueError:
        return None
    return values if any(math.isfinite(value) for value in values) else None


def _chosen(wanted: Sequence[str], there: list[str], what: str, columns: list[str]) -> list[str]:
    for name in wanted:
        if name not in there:
            why = "is not a number" if name in columns else "is not there"
            raise SweepError(f"the {what} '{name}' {why}", hint=nearest(name, there))
    return list(wanted) or there


def _draw(path: pathlib.Path, across: dict[str, list[float]], up: dict[str, list[float]]) -> None:
    need("matplotlib", "a plot")
    # without pyplot, whose figures and display belong to the user, for example in a notebook
    figure = need("matplotlib.figure", "a plot").Figure(figsize=(_SIZE[0] * len(across), _SIZE[1] * len(up)),
                                                        layout="constrained")
    if path.suffix.lstrip(".") not in figure.canvas.get_supported_filetypes():
        raise SweepError(f"a picture can't be a '{path.suffix}' file", hint=".png, .svg or .pdf")
    axes = figure.subplots(len(up), len(across), squeeze=False)
    for line, (measure, values) in zip(axes, up.items()):
        for picture, (parameter, places) in zip(line, across.items()):
            picture.plot(places, values, ".", alpha=0.5, markersize=5)
            means = _means(places, values)
            if means:
                picture.plot(list(means), list(means.values()), "-", linewidth=1)
            picture.set_xlabel(parameter)
            picture.set_ylabel(measure)
            picture.grid(alpha=0.3)
    try:
        figure.savefig(path, dpi=120)
    except OSError as error:
        raise SweepError(f"{path}: {error.strerror}") from None


def _means(places: list[float], values: list[float]) -> dict[float, float]:
    """Returns the mean for each value, in order; nothing if all values are different, or there are too many."""
    groups: dict[float, list[float]] = collections.defaultdict(list)
    for place, value in zip(places, values):
        if math.isfinite(place) and math.isfinite(value):
            groups[place].append(value)
    if len(groups) > _MOST_MEANS or all(len(group) == 1 for group in groups.values()) and len(groups) > 20:
        return {}
    return {place: statistics.fmean(groups[place]) for place in sorted(groups)}
