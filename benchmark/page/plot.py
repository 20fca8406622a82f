# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Draws lines over two logarithmic axes as SVG, with nothing but Python."""

import math
from xml.sax.saxutils import escape

WIDTH, HEIGHT = 760, 460
LEFT, RIGHT, TOP, BOTTOM = 84, 230, 40, 50  # the right margin holds the names
COLORS = ["#000000", "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9",
          "#7f7f7f", "#8b4513", "#6a3d9a", "#b2b200", "#1b7837", "#f781bf"]
LINE_HEIGHT = 16


def short(value):
    """1500 as 1.5k; powers of ten become 1k, 1M, 0.01."""
    for size, letter in ((1e9, "G"), (1e6, "M"), (1e3, "k")):
        if value >= size:
            return f"{value / size:g}{letter}"
    return f"{value:g}"


class Axis:
    """Maps values to pixels; its range ends a little beyond the values."""

    def __init__(self, values, begin, end):
        low, high = math.log10(min(values)), math.log10(max(values))
        margin = 0.05 * max(high - low, 0.2)
        self.low, self.high = low - margin, high + margin
        self.begin, self.end = begin, end

    def __call__(self, value):
        share = (math.log10(value) - self.low) / (self.high - self.low)
        return self.begin + share * (self.end - self.begin)

    def ticks(self):
        """Powers of ten, with 2 and 5 times them where there are few."""
        steps = [1] if self.high - self.low > 2.5 else [1, 2, 5]
        candidates = [step * 10.0 ** power for step in steps
                      for power in range(math.floor(self.low) - 1, math.ceil(self.high) + 1)]
        return sorted(v for v in candidates if self.low <= math.log10(v) <= self.high)


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


def grid(x, y, x_label, y_label, title):
    yield text(LEFT, 22, title, more='font-weight="bold"')
    for v in x.ticks():
        yield (f'<path d="M{x(v):.1f} {TOP}V{HEIGHT - BOTTOM}" stroke="#ddd"/>'
               + text(x(v), HEIGHT - BOTTOM + 18, short(v), "middle"))
    for v in y.ticks():
        yield (f'<path d="M{LEFT} {y(v):.1f}H{WIDTH - RIGHT}" stroke="#ddd"/>'
               + text(LEFT - 8, y(v) + 4, short(v), "end"))
    yield text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 12, x_label, "middle")
    yield text(-(TOP + HEIGHT - BOTTOM) / 2, 18, y_label, "middle", 'transform="rotate(-90)"')


def power(x_values, y, exponent):
    """Points of y ~ x^exponent, over the extent of x_values, with y at the greatest of them."""
    low, high = min(x_values), max(x_values)
    return [(x, y * (x / high) ** exponent) for x in (low, high)]


def log_log(lines, x_label, y_label, title, dashed=()):
    """lines: name -> list of (x, y), all positive, at least one point in all. Those named in
    `dashed` are for comparison, and drawn without marks. The SVG as text."""
    lines = {name: sorted(points) for name, points in lines.items() if points}
    every = [point for points in lines.values() for point in points]
    x = Axis([p[0] for p in every], LEFT, WIDTH - RIGHT)
    y = Axis([p[1] for p in every], HEIGHT - BOTTOM, TOP)
    parts = list(grid(x, y, x_label, y_label, title))
    heights = spread([y(points[-1][1]) for points in lines.values()])
    for k, (name, points) in enumerate(lines.items()):
        color = "#888888" if name in dashed else COLORS[k % len(COLORS)]
        corners = " ".join(f"{x(a):.1f},{y(b):.1f}" for a, b in points)
        end_x, end_y = x(points[-1][0]), y(points[-1][1])
        style = 'stroke-dasharray="6 4"' if name in dashed else 'stroke-width="2"'
        parts.append(f'<polyline points="{corners}" fill="none" stroke="{color}" {style}/>')
        parts += [f'<circle cx="{x(a):.1f}" cy="{y(b):.1f}" r="3" fill="{color}"/>'
                  for a, b in points if name not in dashed]
        parts.append(f'<path d="M{end_x + 5:.1f} {end_y:.1f}L{WIDTH - RIGHT + 12} '
                     f'{heights[k]:.1f}" stroke="{color}" stroke-dasharray="1 3" fill="none"/>')
        parts.append(text(WIDTH - RIGHT + 16, heights[k] + 4, name, more=f'fill="{color}"'))
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
            f'width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" font-size="13">\n'
            f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>\n'
            + "\n".join(parts) + "\n</svg>\n")
