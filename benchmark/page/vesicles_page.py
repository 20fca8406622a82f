# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/vesicles.md, from the record of benchmark/measure_vesicles."""

import math

from page import plot
from page.tables import extent, grouped, table

SIZE = 110  # pixels of a shape
SCALE = 30  # of the radius


def error(row):
    """of the energy, in percent"""
    return 100 * (row["energy"] / row["exact"] - 1)


def shape_table(rows):
    volumes = sorted({row["volume"] for row in rows}, reverse=True)
    lines = []
    for (branch,), some in grouped(rows, "branch").items():
        errors = {v: "/".join(f"{error(row):.2f}" for row in pair) for (v,), pair in grouped(some, "volume").items()}
        lines.append([branch, *(errors.get(v, "") for v in volumes)])
    return table(["v", *(f"{v:g}" for v in volumes)], lines)


def slopes(rows):
    """of the errors by the root of the number of vertices"""
    for pair in grouped(rows, "branch", "volume").values():
        coarse, fine = sorted(pair, key=lambda row: row["rings"])
        yield 2 * math.log(abs(error(coarse) / error(fine))) / math.log(fine["vertices"] / coarse["vertices"])


def remarks(rows):
    shapes = of_table(rows, "shapes")
    worst = max(abs(row["volume_error"]) for row in shapes)
    crossings = " and ".join(f"{row['volume']:.3f}" for row in of_table(rows, "crossings"))
    return (f"Volumes are met to {worst:.0e}; slopes are {extent(slopes(shapes), '.1f')}. By the shape equations, "
            f"branches cross at v = {crossings}; published are .652 and .592.")


def of_table(rows, name):
    return [row for row in rows if row["table"] == name]


def blocks(rows):
    return {"shapes": shape_table(of_table(rows, "shapes")), "remarks": remarks(rows)}


def outline(row, x, y, color):
    """the section of a shape through its axis"""
    right = [(r, -z) for r, z in row["profile"]]
    middle = (max(z for _, z in right) + min(z for _, z in right)) / 2
    every = right + [(-r, z) for r, z in reversed(right)]
    corners = " ".join(f"{x + SCALE * r:.1f},{y + SCALE * (z - middle):.1f}" for r, z in every)
    return f'<polygon points="{corners}" fill="{color}" fill-opacity=".2" stroke="{color}" stroke-width="1.5"/>'


def sections(shapes):
    """one row of sections for each branch, one column for each volume"""
    branches = list(dict.fromkeys(row["branch"] for row in shapes))
    volumes = sorted({row["volume"] for row in shapes}, reverse=True)
    heights = [sum((SIZE + 60, SIZE, SIZE)[:k]) for k in range(3)]
    parts = [plot.text(120 + SIZE * k, 50, f"v = {v:g}", "middle") for k, v in enumerate(volumes)]
    for row in shapes:
        k = branches.index(row["branch"])
        parts.append(outline(row, 120 + SIZE * volumes.index(row["volume"]), 140 + heights[k], plot.COLORS[k]))
    parts += [plot.text(12, 144 + heights[k], name) for k, name in enumerate(branches)]
    return plot.svg(480, "Sections through the axis", parts)


def figures(rows):
    shapes = of_table(rows, "shapes")
    fine = [row for row in shapes if row["rings"] == max(row["rings"] for row in shapes)]
    lines = {}
    for (branch,), some in grouped(fine, "branch").items():
        lines[branch] = [(row["volume"], row["energy"]) for row in some]
        lines[f"{branch}, exact"] = [(row["volume"], row["exact"]) for row in some]
    exact = [name for name in lines if name.endswith("exact")]
    return {"vesicles.svg": plot.curves(lines, "reduced volume", "energy / 4 pi", "Shapes of vesicles", exact, log=""),
            "vesicle_sections.svg": sections(fine)}
