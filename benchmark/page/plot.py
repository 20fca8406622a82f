# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Draws plots as SVG, with nothing but Python: curves, distributions, rows of dots, and rows of bars.
The same values always are the same text."""

import math
from xml.sax.saxutils import escape

WIDTH, HEIGHT = 760, 460
LEFT, RIGHT, TOP, BOTTOM = 84, 230, 40, 50  # the right margin holds the names
COLORS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#000000", "#56b4e9",
          "#7f7f7f", "#8b4513", "#6a3d9a", "#b2b200", "#1b7837", "#f781bf"]
LINE_HEIGHT = 16
LETTER = 7  # mean width


LEAST = 1e-4  # of an error that is drawn on a logarithmic axis


def error(q):
    """What a quasi-conformal error has above 1, which is perfect."""
    return max(q - 1, LEAST)


def short(value):
    """1500 as 1.5k; powers of ten become 1k, 1M, 0.01."""
    for size, letter in ((1e9, "G"), (1e6, "M"), (1e3, "k")):
        if abs(value) >= size:
            return f"{value / size:g}{letter}"
    return f"{value:.6g}"


class Axis:
    """Maps values to pixels; its range ends a little beyond the values."""

    def __init__(self, values, begin, end, is_log=True):
        self.map = math.log10 if is_log else float
        low, high = self.map(min(values)), self.map(max(values))
        margin = 0.05 * max(high - low, 0.2 if is_log else 1e-9 * abs(high) or 1)
        self.low, self.high = low - margin, high + margin
        self.begin, self.end, self.is_log = begin, end, is_log

    def __call__(self, value):
        share = (self.map(value) - self.low) / (self.high - self.low)
        return self.begin + share * (self.end - self.begin)

    def ticks(self):
        """Powers of ten, with 2 and 5 times them where there are few; else four to nine round numbers."""
        steps = [1] if self.high - self.low > 3 else [1, 2, 5]
        powers = range(math.floor(self.low) - 1, math.ceil(self.high) + 1, math.ceil((self.high - self.low) / 8))
        found = [step * 10.0 ** power for power in powers for step in steps
                 if self.low <= math.log10(step) + power <= self.high] if self.is_log else []
        return found if len(found) > 2 else round_numbers(*(10 ** v if self.is_log else v
                                                            for v in (self.low, self.high)))


def round_numbers(low, high):
    step = 10.0 ** math.floor(math.log10((high - low) / 4))
    step *= next(k for k in (5, 2, 1) if (high - low) / (k * step) >= 4)
    return [k * step for k in range(math.ceil(low / step), math.floor(high / step) + 1)]


def spread(heights, last=HEIGHT - BOTTOM):
    """The same heights, moved as far as it takes to keep them a line apart and above the last."""
    order = sorted(range(len(heights)), key=lambda i: heights[i])
    moved = list(heights)
    for before, after in zip(order, order[1:]):
        moved[after] = max(moved[after], moved[before] + LINE_HEIGHT)
    for i in reversed(order):
        moved[i] = min(moved[i], last)
        last = moved[i] - LINE_HEIGHT
    return moved


def text(x, y, content, anchor="start", more=""):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" {more}>{escape(content)}</text>'


def svg(height, title, parts):
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" '
            f'width="{WIDTH}" height="{height}" font-family="sans-serif" font-size="13">\n'
            f'<rect width="{WIDTH}" height="{height}" fill="white"/>\n'
            + "\n".join([text(12, 22, title, more='font-weight="bold"'), *parts]) + "\n</svg>\n")


def vertical_grid(x, label, left, right, bottom):
    for v in x.ticks():
        yield (f'<path d="M{x(v):.1f} {TOP}V{bottom}" stroke="#ddd"/>'
               + text(x(v), bottom + 18, short(v), "middle"))
    yield text((left + right) / 2, bottom + 38, label, "middle")


def grid(x, y, x_label, y_label):
    yield from vertical_grid(x, x_label, LEFT, WIDTH - RIGHT, HEIGHT - BOTTOM)
    for v in y.ticks():
        yield (f'<path d="M{LEFT} {y(v):.1f}H{WIDTH - RIGHT}" stroke="#ddd"/>'
               + text(LEFT - 8, y(v) + 4, short(v), "end"))
    yield text(-(TOP + HEIGHT - BOTTOM) / 2, 18, y_label, "middle", 'transform="rotate(-90)"')


def power(x_values, y, exponent):
    """Points of y ~ x^exponent, over the extent of x_values, with y at the greatest of them."""
    low, high = min(x_values), max(x_values)
    return [(x, y * (x / high) ** exponent) for x in (low, high)]


def curve(name, points, color, is_dashed, marks, height):
    """points: in pixels; the name is to the right, at a height."""
    end_x, end_y = points[-1]
    style = 'stroke-dasharray="6 4"' if is_dashed else 'stroke-width="2"'
    corners = " ".join(f"{a:.1f},{b:.1f}" for a, b in points)
    yield f'<polyline points="{corners}" fill="none" stroke="{color}" {style}/>'
    if marks and not is_dashed:
        yield from (f'<circle cx="{a:.1f}" cy="{b:.1f}" r="3" fill="{color}"/>' for a, b in points)
    yield (f'<path d="M{end_x + 5:.1f} {end_y:.1f}L{WIDTH - RIGHT + 12} {height:.1f}" '
           f'stroke="{color}" stroke-dasharray="1 3" fill="none"/>')
    yield text(WIDTH - RIGHT + 16, height + 4, name, more=f'fill="{color}"')


def curves(lines, x_label, y_label, title, dashed=(), log="xy", marks=True):
    """lines: name -> list of (x, y), at least one point in all, positive on logarithmic axes. Those
    named in `dashed` are for comparison, and drawn without marks. The SVG as text."""
    lines = {name: sorted(points) for name, points in lines.items() if points}
    every = [point for points in lines.values() for point in points]
    x = Axis([p[0] for p in every], LEFT, WIDTH - RIGHT, "x" in log)
    y = Axis([p[1] for p in every], HEIGHT - BOTTOM, TOP, "y" in log)
    parts = list(grid(x, y, x_label, y_label))
    heights = spread([y(points[-1][1]) for points in lines.values()])
    for k, (name, points) in enumerate(lines.items()):
        color = "#888888" if name in dashed else COLORS[k % len(COLORS)]
        parts += curve(name, [(x(a), y(b)) for a, b in points], color, name in dashed, marks, heights[k])
    return svg(HEIGHT, title, parts)


def steps(values):
    """The share of the values, in percent, that are at most as large."""
    values, last = sorted(values), 0
    for k, value in enumerate(values, 1):
        yield from ((value, last), (value, 100 * k / len(values)))
        last = 100 * k / len(values)


def distributions(values, x_label, title, log="x", what="cases"):
    """values: name -> list of numbers."""
    lines = {name: list(steps(some)) for name, some in values.items() if some}
    return curves(lines, x_label, f"% of the {what} with at most so much", title, log=log, marks=False)


def legend(names, colors, top=TOP + 8):
    for k, name in enumerate(names):
        y = top + 20 * k
        yield f'<circle cx="{WIDTH - RIGHT + 22}" cy="{y}" r="5" fill="{colors[name]}"/>'
        yield text(WIDTH - RIGHT + 34, y + 4, name)


def parts_of(table):
    """The names in all rows, in their order, each with a color."""
    names = list(dict.fromkeys(name for row in table.values() for name in row))
    return dict(zip(names, COLORS * (1 + len(names) // len(COLORS))))


def left_of(table):
    return 24 + LETTER * max(map(len, table))


def dots(table, x_label, title, log=True):
    """table: name of a row -> name of a dot -> value; names of dots are shared by the rows."""
    colors, left = parts_of(table), left_of(table)
    bottom = TOP + 10 + 22 * max(len(table), len(colors))
    x = Axis([v for row in table.values() for v in row.values()], left, WIDTH - RIGHT, log)
    parts = [*vertical_grid(x, x_label, left, WIDTH - RIGHT, bottom), *legend(colors, colors)]
    for k, (name, row) in enumerate(table.items()):
        y = TOP + 16 + 22 * k
        parts += [f'<path d="M{left:.1f} {y}H{WIDTH - RIGHT}" stroke="#eee"/>', text(left - 8, y + 4, name, "end")]
        parts += [f'<circle cx="{x(v):.1f}" cy="{y}" r="5" fill="{colors[dot]}" fill-opacity="0.8"/>'
                  for dot, v in row.items()]
    return svg(bottom + BOTTOM, title, parts)


def bar(row, colors, left, y):
    """Shares of the whole width, with their numbers where there is room."""
    x, total = left, sum(row.values())
    for name, count in row.items():
        width = (WIDTH - RIGHT - left) * count / total
        yield f'<rect x="{x:.1f}" y="{y}" width="{width:.1f}" height="18" fill="{colors[name]}"/>'
        if width > 10 + LETTER * len(f"{count:,}"):
            yield text(x + width / 2, y + 13, f"{count:,}", "middle", 'fill="white" font-size="11"')
        x += width


def bars(table, title, colors=None):
    """table: name of a row -> name of a part -> how many."""
    colors = {**parts_of(table), **(colors or {})}
    left, bottom = left_of(table), TOP + 10 + 24 * max(len(table), len(parts_of(table)))
    parts = list(legend(parts_of(table), colors))
    for k, (name, row) in enumerate(table.items()):
        y = TOP + 4 + 24 * k
        parts += [text(left - 8, y + 13, name, "end"), *bar(row, colors, left, y)]
    return svg(bottom, title, parts)
