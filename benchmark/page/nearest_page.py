# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/nearest.md, from the record of benchmark/survey_nearest."""

import statistics

from page import plot
from page.tables import extent, grouped, percent, table

COARSE = 300  # faces of a mesh on which a bend is more than a few turned faces
WAYS = {"curvature": "curvature_", "positions": "positions_", "nearest": ""}


def ratio(row, prefix=""):
    return row[prefix + "distance"] / row["source_distance"]


def cells(name, way, rows):
    prefix = WAYS[way]
    return [name, way, str(len(rows)), percent(rows, lambda row: ratio(row, prefix) <= 0.5),
            percent(rows, lambda row: ratio(row, prefix) > 1 + 1e-9),
            f"{statistics.median(ratio(row, prefix) for row in rows):.2f}",
            percent(rows, lambda row: row[prefix + "verified"])]


def share_table(rows):
    parts = {"all": rows, **{motion + "s": [row for row in rows if row["motion"] == motion]
                             for motion in ("bend", "twist")}}
    return table(["motions", "way", "cases", "at most half as far", "farther", "median", "verified"],
                 [cells(name, way, some) for name, some in parts.items() for way in WAYS])


def quality_table(rows):
    return table(["nearest", "least / median / greatest"], [
        ["normals, by those of the source", extent(row["normals"] for row in rows)],
        ["Q of the target", extent((row["target_Q"] for row in rows), ".3f")],
        ["Q", extent((row["Q"] for row in rows), ".3f")],
        ["solves", extent((row["solves"] for row in rows), ",.0f")],
        ["factorizations", extent((row["factorizations"] for row in rows), ".0f")]])


def trade_off(rows):
    return [row for row in rows if row.get("table") == "trade_off"]


def trade_off_table(rows):
    return table(["--advanced shear", "Q", "distance, by that of the source"], [
        [f"{shear:g}", extent((row["Q"] for row in some), ".3f"), extent(row["distance"] for row in some)]
        for (shear,), some in grouped(rows, "shear").items()])


def counted(rows):
    return [row for row in rows if row.get("faces", 0) >= COARSE]


def blocks(rows):
    fits = counted(rows)
    return {"shares": share_table(fits), "quality": quality_table(fits),
            "trade_off": trade_off_table(trade_off(rows))}


def figures(rows):
    values = {way: [ratio(row, prefix) for row in counted(rows)] for way, prefix in WAYS.items()}
    lines = {mesh: [(row["distance"], plot.error(row["Q"])) for row in some]
             for (mesh,), some in grouped(trade_off(rows), "mesh").items()}
    label = "distance from the target, by that of the source"
    return {"nearest.svg": plot.distributions(values, label, "How near conformal deformations come", log=""),
            "nearest_trade_off.svg": plot.curves(lines, label, "mean quasi-conformal error, less 1",
                                                 "Nearer to a twist, or to conformal", log="y")}
