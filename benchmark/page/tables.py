# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Tables in Markdown."""

import statistics


def table(header, rows):
    """The first column is of words, the others are of numbers."""
    lines = [header, ["---"] + ["--:"] * (len(header) - 1), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def seconds(value):
    return f"{value:.4f}" if value < 0.1 else f"{value:.3f}" if value < 10 else f"{value:.1f}"


def count(rows, is_so):
    return sum(map(is_so, rows))


def percent(rows, is_so, digits=0):
    return f"{100 * count(rows, is_so) / max(1, len(rows)):.{digits}f} %"


def extent(values, form=".2f"):
    """The least, the median and the greatest, in this order; empty where there is none."""
    values = [value for value in values if value is not None]
    return " / ".join(f"{f(values):{form}}" for f in (min, statistics.median, max)) if values else ""


def grouped(rows, *keys):
    """tuple of values -> the rows that have them, in the order of the rows."""
    groups = {}
    for row in rows:
        groups.setdefault(tuple(row[key] for key in keys), []).append(row)
    return groups
