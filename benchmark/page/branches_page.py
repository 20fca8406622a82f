# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/branches.md, from the record of benchmark/survey_branches."""

import statistics

from page import plot
from page.tables import count, extent, grouped, percent, table

SAME = 0.99  # overlap of two vectors on one branch


def cases(rows):
    return [row for row in rows if "least_overlap" in row]


def is_clear(row):
    return row["least_overlap"] >= SAME


def is_same(row):
    return row["converged"] and row["agreement"] >= SAME


def overall(rows):
    clear = list(filter(is_clear, rows))
    others = [row for row in clear if not is_same(row)]
    named = "; ".join(f"{row['mesh'].removesuffix('.off')} ({row['faces']:,} faces), {row['potential']}, "
                      f"{row['amplitude']}" for row in others)
    return (f"**{percent(clear, is_same, 1)} of {len(clear)} cases on {len({row['mesh'] for row in rows})} meshes are "
            f"the same; {count(others, lambda row: row['converged'])} have converged to another vector.** The others: "
            f"{named}. Of {len(rows)} cases, {len(rows) - len(clear)} are not counted, because their 24 steps are too "
            "long to tell.")


def cells(name, rows):
    clear = list(filter(is_clear, rows))
    shifts = [row["shift_changes"] for row in rows if row["shift_converged"]]
    return [name, str(len(clear)), percent(clear, is_same, 1),
            f"{statistics.mean(row['factorizations'] for row in rows):.2f}",
            percent(rows, lambda row: row["factorizations"] <= 3, 1),
            f"{statistics.mean(row['solves'] for row in rows):.0f}", extent(shifts, ".0e")]


def case_table(rows):
    amplitudes = sorted(grouped(rows, "amplitude").items())
    return table(["amplitude", "cases", "same", "factorizations", "at most 3", "solves", "shift"],
                 [*(cells(str(a), some) for (a,), some in amplitudes), cells("all", rows)])


def sweeps(rows):
    return {mesh.removesuffix(".off"): some
            for (mesh,), some in grouped([row for row in rows if "move" in row], "mesh").items()}


def jumps(rows):
    return [row for last, row in zip(rows, rows[1:]) if row["move"] > max(0.01, 4 * last["move"])]


def sweep_table(rows):
    return table(["mesh", "verified", "move", "jumps", "shifted, at most"], [
        [mesh, f"{count(some, lambda row: row['verified'])} of {len(some)}",
         extent((row["move"] for row in some), ".4f"), str(len(jumps(some))),
         f"{max(row['shifted'] for row in some):.0e}"]
        for mesh, some in sweeps(rows).items()])


def spectra(rows):
    return table(["surface", "shifts", "error", "found", "exact"], [
        [surface, str(len(some)), extent((row["error"] for row in some), ".3f"),
         *(str(sum(row[key] for row in some)) for key in ("found", "exact"))]
        for (surface,), some in grouped([row for row in rows if "spectrum" in row], "spectrum").items()])


def verdicts(rows):
    return table(["command", "exit code"], [[f"`{row['command']}`", str(row["code"])] for row in rows
                                            if "command" in row])


def blocks(rows):
    return {"overall": overall(cases(rows)), "cases": case_table(cases(rows)), "sweeps": sweep_table(rows),
            "spectra": spectra(rows), "verdicts": verdicts(rows)}


def figures(rows):
    return {"branches.svg": plot.curves(
        {mesh: [(row["amplitude"], row["Q"]) for row in some] for mesh, some in sweeps(rows).items()},
        "amplitude A", "mean quasi-conformal error", "rho = A sin 5y, 40 amplitudes", log="")}
