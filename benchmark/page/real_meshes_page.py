# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/real_meshes.md, from the record of benchmark/real_meshes."""

from page import plot
from page.tables import count, extent, table


def kinds(rows):
    meshes = [row for row in rows if "mesh" in row]
    return {"genus 0": [row for row in meshes if row["genus"] == 0],
            "with handles": [row for row in meshes if row["genus"]]}


def is_done(row):
    return row["outcome"] == "done"


def summary(rows):
    meshes = [row for row in rows if "mesh" in row]
    left = rows[0]
    return (f"{count(meshes, is_done)} of {len(meshes)} are done; the others are refused, or computed and not written "
            f"because the result does not verify. Left out are {left['bounded']} meshes with boundary, and "
            f"{left['unreadable']} that cannot be read as a surface.")


def quality_table(rows):
    return table(["", *kinds(rows)], [
        [name, *(extent((row.get(key) for row in some if is_done(row)), form) for some in kinds(rows).values())]
        for name, key, form in (
            ("faces", "faces", ",.0f"), ("Q mean", "q_mean", ".4f"), ("Q 99 %", "q_p99", ".3f"),
            ("Q max", "q_max", ".3g"), ("flipped faces", "flips", ".0f"), ("closure", "closure", ".0e"),
            ("% of rho left out", "left_out", ".0f"), ("seconds", "seconds", ".1f"))])


def refusals(rows):
    return "\n".join(f"- {row['mesh']}, {row['faces']:,} faces: {row['outcome'].split(';')[0]}"
                     for row in rows if "mesh" in row and not is_done(row))


def blocks(rows):
    return {"summary": summary(rows), "quality": quality_table(rows), "refusals": refusals(rows)}


def figures(rows):
    return {"real_meshes.svg": plot.distributions(
        {name: [plot.error(row["q_mean"]) for row in some if is_done(row)] for name, some in kinds(rows).items()},
        "mean quasi-conformal error, less 1", "Angles on real meshes", what="meshes")}
