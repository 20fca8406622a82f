# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/benchmarks.md, from the record of benchmark/report."""

from page import plot
from page.tables import grouped, table


def of_table(rows, name):
    return [row for row in rows if row.get("table") == name]


def stage_table(rows):
    """On the finest mesh."""
    stages = of_table(rows, "stages")
    most = max(row["vertices"] for row in stages)
    return table([f"stage, {most:,.0f} vertices", "seconds", "ratio", "memory", "factor entries"], [
        [f"`{row['stage']}`", f"{row['seconds']:.4f}", f"{row['ratio']:.2f}", f"{row['kilobytes']:.2f} kB",
         f"{row['factor_entries']:,.0f}" if "factor_entries" in row else ""]
        for row in stages if row["vertices"] == most])


def flow_table(rows):
    return table(["surface", "faces", "first, seconds", "later", "later / first", "trials"], [
        [row["surface"], f"{row['faces']:,.0f}", f"{row['first']:.3f}", f"{row['later']:.3f}",
         f"{row['later'] / row['first']:.2f}", f"{row['trials']:.1f}"] for row in of_table(rows, "flows")])


def curve_table(rows):
    return table(["vertices", "closing", "steps per second", "ratio", "distortion", "memory"], [
        [f"{row['vertices']:,.0f}", row["closing"], f"{row['steps_per_second']:,.0f}", f"{row['ratio']:.1f}",
         f"{row['length_distortion']:.1e}", f"{row['bytes']:.0f} B"] for row in of_table(rows, "curves")])


def blocks(rows):
    return {"machine": rows[0]["machine"], "stages": stage_table(rows), "flows": flow_table(rows),
            "curves": curve_table(rows)}


def figures(rows):
    return {"benchmarks.svg": plot.curves(
        {stage: [(row["vertices"], 1e6 * row["seconds"] / row["vertices"]) for row in some]
         for (stage,), some in grouped(of_table(rows, "stages"), "stage").items()},
        "vertices", "microseconds per vertex", "Time of every stage")}
