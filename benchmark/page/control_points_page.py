# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/control_points.md, from the record of benchmark/measure_control_points."""

from page import plot
from page.tables import count, extent, grouped, table

CONFORMAL = "conformal"
WAYS = [CONFORMAL, "ARAP", "SRE-ARAP"]


def of_way(rows, way):
    return [row for row in rows if row["way"] == way]


def moves_in_words(rows, distance):
    """How many moves are met, and how well."""
    rows = [row for row in rows if row["distance"] == distance]
    met = [row for row in rows if row["reached"] == 1 and row["missed"] <= 1e-8]
    factorizations = [row["factorizations"] for row in met]
    text = (f"- Moves by {distance:g} radius: {len(met)} of {len(rows)} are met to 1e-8 of the diagonal, with mean Q "
            f"at most {max(row['q_mean'] for row in met):.4f}; by {min(factorizations)} to {max(factorizations)} "
            "factorizations.")
    if missed := [f"{row['mesh']} {row['reached']:.2f}" for row in rows if row not in met]:
        text += f" Shares of the way of the others: {', '.join(missed)}."
    return text


def drags_in_words(rows):
    costs = [row["drag_seconds"] for row in rows if "drag_seconds" in row]
    return (f"- Dragging on costs {min(costs):.1f} to {max(costs):.1f} P each time, and at most 10 P in "
            f"{count(costs, lambda cost: cost <= 10)} of {len(costs)} cases.")


def way_table(rows):
    return table(["method", "move", "Q mean", "Q max", "lengths", "dihedral", "P", "P per drag"], [
        [way, f"{distance:g}", *(extent((row.get(key) for row in some), form) for key, form in (
            ("q_mean", ".3f"), ("q_max", ".3g"), ("lengths", ".3f"), ("dihedral", ".2f"), ("seconds", ".0f"),
            ("drag_seconds", ".1f")))]
        for way in WAYS for (distance,), some in grouped(of_way(rows, way), "distance").items()])


def blocks(rows):
    moves = of_way(rows, CONFORMAL)
    return {"moves": "\n".join([moves_in_words(moves, 0.3), moves_in_words(moves, 1), drags_in_words(moves)]),
            "ways": way_table(rows)}


def by_case(rows, value):
    """mesh and move -> way -> value"""
    return {f"{mesh}, {distance:g}": {row["way"]: value(row) for row in some if row["way"] in WAYS}
            for (mesh, distance), some in grouped(rows, "mesh", "distance").items()}


def figures(rows):
    return {"control_points_angles.svg": plot.dots(
                by_case(rows, lambda row: plot.error(row["q_mean"])), "mean quasi-conformal error, less 1",
                "Angles after a move by .3 and by 1 radius"),
            "control_points_costs.svg": plot.dots(
                by_case(rows, lambda row: row["seconds"]), "multiples of P", "Cost of a move")}
