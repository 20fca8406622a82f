# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Draws histograms over one another as SVG, with nothing but Python."""

from page.plot import BOTTOM, COLORS, HEIGHT, LEFT, RIGHT, TOP, WIDTH, text

BINS = 50


def shares(weighted, low, high):
    """The share of the weight in each bin; what lies beyond is in the last one."""
    total, bins = sum(weight for _, weight in weighted), [0.0] * BINS
    for value, weight in weighted:
        place = int((value - low) / (high - low) * BINS)
        bins[min(max(place, 0), BINS - 1)] += weight / total
    return bins


def outline(bins, x, y):
    """The steps of a histogram, from the axis to the axis."""
    corners = [(x(0), y(0))]
    for i, share in enumerate(bins):
        corners += [(x(i / BINS), y(share)), (x((i + 1) / BINS), y(share))]
    return " ".join(f"{a:.1f},{b:.1f}" for a, b in [*corners, (x(1), y(0))])


def histogram(series, low, high, x_label, y_label, title):
    """series: name -> list of (value, weight). The SVG as text."""
    bins = {name: shares(weighted, low, high) for name, weighted in series.items()}
    top = max(max(values) for values in bins.values())

    def x(share):
        return LEFT + share * (WIDTH - RIGHT - LEFT)

    def y(share):
        return HEIGHT - BOTTOM - share / top * (HEIGHT - BOTTOM - TOP)

    parts = [text(LEFT, 22, title, more='font-weight="bold"'),
             text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 12, x_label, "middle"),
             text(-(TOP + HEIGHT - BOTTOM) / 2, 18, y_label, "middle",
                  'transform="rotate(-90)"')]
    for k in range(6):
        place = x(k / 5)
        parts.append(f'<path d="M{place:.1f} {TOP}V{HEIGHT - BOTTOM}" stroke="#ddd"/>')
        parts.append(text(place, HEIGHT - BOTTOM + 18, f"{low + (high - low) * k / 5:g}", "middle"))
        parts.append(text(LEFT - 8, y(top * k / 5) + 4, f"{100 * top * k / 5:.0f} %", "end"))
    for k, (name, values) in enumerate(bins.items()):
        color = COLORS[k]
        mean = sum(v * w for v, w in series[name]) / sum(w for _, w in series[name])
        parts.append(f'<polygon points="{outline(values, x, y)}" fill="{color}" '
                     f'fill-opacity="0.25" stroke="{color}" stroke-width="1.5"/>')
        parts.append(text(WIDTH - RIGHT + 16, TOP + 40 * k + 12, name, more=f'fill="{color}"'))
        parts.append(text(WIDTH - RIGHT + 16, TOP + 40 * k + 28, f"mean {mean:.4f}",
                          more=f'fill="{color}"'))
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" '
            f'width="{WIDTH}" height="{HEIGHT}" font-family="sans-serif" font-size="13">\n'
            f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>\n'
            + "\n".join(parts) + "\n</svg>\n")
