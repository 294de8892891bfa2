"""Draws error against cost as SVG, of what tools/bench engines --csv has measured: plot.py FILE.csv FILE.svg"""

import csv
import html
import math
import sys

WIDTH, HEIGHT, GAP = 300, 260, 60
COLOURS = {"pongsim": "#c0392b", "MuJoCo": "#2471a3", "DART": "#229954", "Bullet": "#b7950b"}
INK, GRID = "#555", "#ccc"


def read(path):
    """By world: rows of engine, length of a step, cost of a simulated second [s], error; with the error's unit."""
    worlds = {}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            if not row["error"]:
                continue
            step, error = float(row["step [s]"]), float(row["error"])
            cost = float(row["cost [us]"]) * 1e-6 / step
            worlds.setdefault((row["world"], row["unit"]), []).append((row["engine"].split()[0], step, cost, error))
    return worlds


def decades(values):
    """The powers of ten around positive values."""
    found = [value for value in values if value > 0 and math.isfinite(value)]
    return math.floor(math.log10(min(found))), math.ceil(math.log10(max(found)) + 1e-9)


def panel(title, unit, points, left, top):
    x_low, x_high = decades([cost for _, _, cost, _ in points])
    # errors below are rounding errors
    floor = 1e-9
    y_low, y_high = decades([max(error, floor) for *_, error in points])
    x_high, y_high = max(x_high, x_low + 1), max(y_high, y_low + 1)

    def x(value):
        return left + WIDTH * (math.log10(value) - x_low) / (x_high - x_low)

    def y(value):
        return top + HEIGHT * (1 - (math.log10(max(value, floor)) - y_low) / (y_high - y_low))

    parts = [f'<text x="{left}" y="{top - 10}" font-weight="bold">{html.escape(title)}</text>']
    for power in range(x_low, x_high + 1):
        parts.append(
            f'<line x1="{x(10.0 ** power):.1f}" y1="{top}" x2="{x(10.0 ** power):.1f}" y2="{top + HEIGHT}" '
            f'stroke="{GRID}"/><text x="{x(10.0 ** power):.1f}" y="{top + HEIGHT + 16}" '
            f'text-anchor="middle">1e{power}</text>'
        )
    for power in range(y_low, y_high + 1):
        parts.append(
            f'<line x1="{left}" y1="{y(10.0 ** power):.1f}" x2="{left + WIDTH}" y2="{y(10.0 ** power):.1f}" '
            f'stroke="{GRID}"/><text x="{left - 6}" y="{y(10.0 ** power) + 4:.1f}" '
            f'text-anchor="end">1e{power}</text>'
        )
    parts.append(
        f'<text x="{left + WIDTH / 2}" y="{top + HEIGHT + 32}" text-anchor="middle">processor time of a '
        f'simulated second [s]</text><text x="{left}" y="{top + 12}">error{f" [{unit}]" if unit else ", in parts"}'
        "</text>"
    )
    for engine, colour in COLOURS.items():
        own = sorted(
            (step, cost, error) for name, step, cost, error in points if name == engine and math.isfinite(error)
        )
        if len(own) > 1:
            line = " ".join(f"{x(cost):.1f},{y(error):.1f}" for _, cost, error in own)
            parts.append(f'<polyline points="{line}" fill="none" stroke="{colour}"/>')
        for step, cost, error in own:
            parts.append(
                f'<circle cx="{x(cost):.1f}" cy="{y(error):.1f}" r="4" fill="{colour}"><title>{engine}, step '
                f"{1000 * step:g} ms: {cost:.2g} s, {error:.2g}</title></circle>"
            )
    return "".join(parts)


def draw(worlds):
    columns = 2
    rows = math.ceil(len(worlds) / columns)
    width, height = columns * (WIDTH + 2 * GAP), rows * (HEIGHT + 90) + 40
    parts = []
    for i, ((title, unit), points) in enumerate(worlds.items()):
        left, top = GAP + i % columns * (WIDTH + 2 * GAP), 70 + i // columns * (HEIGHT + 90)
        parts.append(panel(title, unit, points, left, top))
    for i, (engine, colour) in enumerate(COLOURS.items()):
        parts.append(
            f'<circle cx="{GAP + 110 * i}" cy="20" r="5" fill="{colour}"/>'
            f'<text x="{GAP + 12 + 110 * i}" y="24">{engine}</text>'
        )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" '
        f'font-size="12" fill="{INK}"><rect width="100%" height="100%" fill="white"/>{"".join(parts)}</svg>\n'
    )


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("plot: error: wants a file of tools/bench engines --csv, and the file to write")
    with open(sys.argv[2], "w") as picture:
        picture.write(draw(read(sys.argv[1])))
