"""The runs of a sweep: values of parameters, their combinations, and seeds."""

from __future__ import annotations

import decimal
import itertools
import random
from typing import Any, Iterator

from .document import Node
from .errors import SweepError
from .plan import Run

#: A larger number is a mistake.
MOST_RUNS = 1_000_000


class Axis:
    """A parameter's values, or the bounds of values to be drawn."""

    def __init__(self, name: str, values: list[Any], between: tuple[float, float] | None, at: Node) -> None:
        self.name = name
        self.values = values
        self.between = between
        self.at = at


def read_axis(name: str, node: Node) -> Axis:
    """The values of one parameter: `values`, `range` or `between`."""
    parts = node.mapping(f"parameter '{name}'")
    given = [key for key in ("values", "range", "between") if key in parts]
    if len(given) != 1:
        node.fail(f"parameter '{name}' has {' and '.join(given) or 'no values'}", "give values, range or between")
    if "values" in parts:
        what = f"a value of '{name}'"
        return Axis(name, [each.scalar(what) for each in parts["values"].list(f"'{name}'.values")], None, node)
    if "range" in parts:
        return Axis(name, _range(name, parts["range"]), None, node)
    bounds = parts["between"].list(f"'{name}'.between")
    if len(bounds) != 2:
        parts["between"].fail(f"'{name}'.between has two numbers, not {len(bounds)}")
    low, high = (each.number(f"a bound of '{name}'") for each in bounds)
    if not low < high:
        parts["between"].fail(f"'{name}'.between: {low:g} is not below {high:g}")
    return Axis(name, [], (low, high), node)


def _range(name: str, node: Node) -> list[Any]:
    parts = node.mapping(f"'{name}'.range", ["from", "to", "step", "count"])
    for key in ("from", "to"):
        if key not in parts:
            node.fail(f"'{name}'.range has no '{key}'", "a range has from, to, and step or count")
    if ("step" in parts) == ("count" in parts):
        node.fail(f"'{name}'.range needs either step or count")
    first, last = (parts[key].number(f"'{key}' of '{name}'") for key in ("from", "to"))
    if "count" in parts:
        count = parts["count"].whole(f"'count' of '{name}'", least=2, most=MOST_RUNS)
        return [first + (last - first) * i / (count - 1) for i in range(count)]
    step = parts["step"].number(f"'step' of '{name}'")
    if step == 0 or (last - first) * step < 0:
        parts["step"].fail(f"steps of {step:g} do not lead from {first:g} to {last:g}")
    # in decimals, so that the result is 0.3 and not 0.30000000000000004
    begin, end, width = (decimal.Decimal(str(each)) for each in (first, last, step))
    count = int((end - begin) / width) + 1
    if count > MOST_RUNS:
        parts["step"].fail(f"that is more than {MOST_RUNS} values")
    whole = all(isinstance(each, int) for each in (first, step))
    return [int(begin + i * width) if whole else float(begin + i * width) for i in range(count)]


def read_seeds(node: Node | None) -> list[int]:
    """Reads `seeds`: a list, a number of seeds, or from and count; the default is 0."""
    if node is None:
        return [0]
    if isinstance(node.value, int):
        return list(range(node.whole("seeds", least=1, most=MOST_RUNS)))
    if isinstance(node.value, dict):
        parts = node.mapping("seeds", ["from", "count"])
        if "count" not in parts:
            node.fail("seeds has no 'count'")
        first = parts["from"].whole("the first seed") if "from" in parts else 0
        return [first + i for i in range(parts["count"].whole("the count of seeds", least=1, most=MOST_RUNS))]
    seeds = [each.whole("a seed") for each in node.list("seeds")]
    if len(set(seeds)) < len(seeds):
        node.fail("a seed is given twice")
    return seeds


def latin_hypercube(samples: int, dimensions: int, seed: int) -> list[list[float]]:
    """Returns points in the unit cube: in each dimension, each of `samples` equal slices contains one (McKay,
    Beckman and Conover 1979). The same seed gives the same points with every version of Python."""
    source = random.Random(seed)
    columns = []
    for _ in range(dimensions):
        # by sorting, because random() is the only function of the module that never changes
        slices = sorted(range(samples), key=lambda _: source.random())
        columns.append([(each + source.random()) / samples for each in slices])
    return [list(point) for point in zip(*columns)]


def make_runs(axes: list[Axis], combine: str, samples: int, sampling_seed: int, seeds: list[int], at: Node) -> list[Run]:
    """Returns all runs, in the order of the file; the seed changes fastest."""
    drawn = [axis for axis in axes if axis.between is not None]
    listed = [axis for axis in axes if axis.between is None]
    points: list[dict[str, Any]] = [{}]
    if drawn:
        points = [
            {axis.name: _scale(axis, share) for axis, share in zip(drawn, point)}
            for point in latin_hypercube(samples, len(drawn), sampling_seed)
        ]
    if combine == "zip":
        combinations = _zipped(listed, points if drawn else None, at)
    else:
        count = len(points) * len(seeds)
        for axis in listed:
            count *= len(axis.values)
        if count > MOST_RUNS:
            at.fail(f"these are {count} runs, more than {MOST_RUNS}")
        combinations = [
            {**dict(zip((axis.name for axis in listed), values)), **point}
            for values in itertools.product(*(axis.values for axis in listed))
            for point in points
        ]
    names = [axis.name for axis in axes]
    return list(_number(names, combinations, seeds))


def _scale(axis: Axis, share: float) -> float:
    assert axis.between is not None
    low, high = axis.between
    return low + (high - low) * share


def _zipped(listed: list[Axis], points: list[dict[str, Any]] | None, at: Node) -> list[dict[str, Any]]:
    lengths = {axis.name: len(axis.values) for axis in listed}
    if points is not None:
        lengths["latin_hypercube"] = len(points)
    if len(set(lengths.values())) > 1:
        at.fail("with 'zip' all parameters have the same number of values", ", ".join(f"{k}: {v}" for k, v in lengths.items()))
    count = next(iter(lengths.values()), 1)
    return [
        {**{axis.name: axis.values[i] for axis in listed}, **(points[i] if points is not None else {})}
        for i in range(count)
    ]


def _number(names: list[str], combinations: list[dict[str, Any]], seeds: list[int]) -> Iterator[Run]:
    if len(combinations) * len(seeds) > MOST_RUNS:
        raise SweepError(f"these are {len(combinations) * len(seeds)} runs, more than {MOST_RUNS}")
    number = 0
    for combination in combinations:
        ordered = {name: combination[name] for name in names}
        for seed in seeds:
            yield Run(number, ordered, seed)
            number += 1
