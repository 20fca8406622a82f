# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/bounded_meshes.md, from the record of benchmark/bounded_meshes."""

from page import plot
from page.tables import count, extent, grouped, table


def runs(rows):
    return [row for row in rows if row["table"] == "runs"]


def is_done(row):
    return row["outcome"].startswith("done")


def reason(outcome):
    """What stands behind the exit code, as far as its first colon."""
    return outcome.split(": ")[1].split(";")[0]


def summary(rows):
    refused = [f"{row['run']} of {row['mesh'].removesuffix('.off')} with {row['boundary']} "
               f"({reason(row['outcome'])})" for row in runs(rows) if not is_done(row)]
    return (f"{count(runs(rows), is_done)} of {len(runs(rows))} are done. The others are refused: "
            + "; ".join(refused) + ".")


def run_table(rows):
    return table(["run", "boundary", "done", "Q mean", "missed, degrees", "seconds"], [
        [run, boundary, f"{len(good)} of {len(some)}", extent((row["q_mean"] for row in good), ".4f"),
         extent(row.get("missed") for row in good), extent((row["seconds"] for row in some), ".1f")]
        for (run, boundary), some in grouped(runs(rows), "run", "boundary").items()
        for good in [list(filter(is_done, some))]])


def minimal_table(rows):
    return table(["mesh", "E / 4 pi, before, after", "Q mean", "gamma R: once, then", "outcome"], [
        [row["mesh"], f"{row['energy_before']:.3f}, {row['energy']:.3f}", f"{row['flow_q_mean']:.4f}",
         f"{row['gamma_radius_once']:.3f}, {row.get('gamma_radius', float('nan')):.3f}",
         "done" if is_done(row) else "refused"] for row in rows if row["table"] == "minimal"])


def quality(rows):
    """mesh -> run -> mean of Q"""
    return {mesh.removesuffix(".off"): {f"{row['run']}, {row['boundary']}": row["q_mean"] - 1
                                        for row in filter(is_done, some)}
            for (mesh,), some in grouped(runs(rows), "mesh").items()}


def blocks(rows):
    return {"summary": summary(rows), "runs": run_table(rows), "minimal": minimal_table(rows)}


def figures(rows):
    return {"bounded_meshes.svg": plot.dots(quality(rows), "mean quasi-conformal error, less 1",
                                            "Angles of surfaces with boundary")}
