# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/regions.md, from the record of benchmark/measure_regions."""

from page import plot
from page.tables import count, extent, grouped, table


def in_words(rows):
    limbs = grouped(rows, "mesh", "limb").values()
    whole = [some for some in limbs if all(row["done"] for row in some)]
    several = [row for row in rows if row["vertices"] and row["vertices"] < row["of"]]
    text = (f"- {len(whole)} of {len(limbs)} limbs are moved all of the way in both directions, "
            f"{count(rows, lambda row: row['done'])} of {len(rows)} moves.\n"
            f"- In {len(several)} cases the ball reaches other parts of the surface, which stay.")
    if refused := [f"{row['mesh']} {row['move']} {row['reached'] or 0:.2f}" for row in rows if not row["done"]]:
        text += f"\n- Shares of the way of the others: {', '.join(refused)}."
    return text


def move_table(rows):
    return table(["move", "moves", "done", "vertices", "Q of the collar", "largest", "seconds"], [
        [move, f"{len(some)}", f"{len(good)}", extent((row["vertices"] for row in some), ".0f"),
         *(extent((row[key] for row in good), form) for key, form in (
             ("q_mean", ".3f"), ("q_max", ".3g"), ("seconds", ".1f")))]
        for (move,), some in grouped(rows, "move").items() for good in [[row for row in some if row["done"]]]])


def blocks(rows):
    return {"summary": in_words(rows), "moves": move_table(rows)}


def figures(rows):
    return {"regions.svg": plot.dots(
        {f"{mesh} {limb}": {row["move"]: plot.error(row["q_mean"]) for row in some if row["done"]}
         for (mesh, limb), some in grouped(rows, "mesh", "limb").items()},
        "mean quasi-conformal error of the collar, less 1", "What collars give")}
