"""Small plots of text."""

from __future__ import annotations

import math
from typing import Sequence

_WIDTH, _HEIGHT = 60, 7


def text_plot(times: Sequence[float], values: Sequence[float], name: str, mark: float | None = None) -> list[str]:
    """Returns the lines of a plot over time; nothing if there is nothing to see.

    mark: a time under which a ^ is put.
    """
    points = [(time, value) for time, value in zip(times, values) if math.isfinite(value)]
    if len(points) < 2 or points[0][0] == points[-1][0]:
        return []
    low, high = min(value for _, value in points), max(value for _, value in points)
    if low == high:
        return [f"{name} = {low:g} from {points[0][0]:g} to {points[-1][0]:g} s"]
    begin, end = points[0][0], points[-1][0]
    rows = [[" "] * _WIDTH for _ in range(_HEIGHT)]
    for time, value in points:
        column = min(_WIDTH - 1, int((time - begin) / (end - begin) * _WIDTH))
        row = min(_HEIGHT - 1, int((high - value) / (high - low) * _HEIGHT))
        rows[row][column] = "*"
    labels = [f"{high:.4g}", *[""] * (_HEIGHT - 2), f"{low:.4g}"]
    wide = max(len(each) for each in labels)
    lines = [name, *(f"{label:>{wide}} |{''.join(row).rstrip()}" for label, row in zip(labels, rows))]
    first, last = f"{begin:.4g}", f"{end:.4g} s"
    axis = [*("-" * _WIDTH)]
    if mark is not None and begin <= mark <= end:
        axis[min(_WIDTH - 1, int((mark - begin) / (end - begin) * _WIDTH))] = "^"
    lines.append(f"{'':>{wide}} +{''.join(axis)}")
    lines.append(f"{'':>{wide}}  {first}{last:>{_WIDTH - len(first)}}")
    return lines
