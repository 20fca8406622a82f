# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/scale_control.md, from the record of benchmark/survey_scales."""

import collections

from page import plot
from page.tables import count, extent, grouped, percent, table

COARSE = 300  # faces of a mesh on which a conformal map is more than a few turned faces
FINE = 1000  # faces of a mesh on which six rings are more than noise
SCANS = 5000  # faces of a mesh whose costs are told in P


def cases(rows):
    return [row for row in rows if "plain_Q" in row]


def is_within(row, prefix=""):
    low, high = row[prefix + "low"], row[prefix + "high"]
    return low is not None and high is not None and low >= 0.4999 and high <= 2.0001


def has_collapsed(row, prefix=""):
    share = row[prefix + "collapsed"]
    return share is None or share >= 0.1


def share_cells(name, rows):
    plain = (percent(rows, lambda row: is_so(row, "plain_"), 1) for is_so in (is_within, has_collapsed))
    bound = (percent(rows, is_so, 1) for is_so in (is_within, has_collapsed, lambda row: row["verified"]))
    return [name, str(len(rows)), *plain, *bound]


def share_table(rows):
    parts = {"all": rows, **{f"at least {least:,} faces": [row for row in rows if row["faces"] >= least]
                             for least in (COARSE, FINE)},
             **{f"A = {a}": some for (a,), some in sorted(grouped(rows, "amplitude").items())}}
    return table(["cases", "number", "plain: within", "collapsed", "bound: within", "collapsed", "verified"],
                 [share_cells(*part) for part in parts.items()])


def cost_table(rows):
    scans = {"genus 0": [row for row in rows if row["faces"] >= SCANS and row["genus"] == 0],
             "with handles": [row for row in rows if row["faces"] >= SCANS and row["genus"] > 0]}
    return table([f"at least {SCANS:,} faces", "cases", "P", "solves", "factorizations"], [
        [name, str(len(some)), extent((row["P"] for row in some), ".1f"),
         *(extent((row[key] for row in some), ".0f") for key in ("solves", "factorizations"))]
        for name, some in scans.items() if some])


def refusals(rows):
    found = [row for row in rows if not row["verified"]]
    reasons = collections.Counter(row["fault"] for row in found)
    fine = sorted({row["mesh"] for row in found if row["faces"] >= COARSE})
    return (f"{count(rows, lambda row: row['mollified'])} cases were solved with mollification. {len(found)} do not "
            f"verify (" + "; ".join(f"{reason}: {n}" for reason, n in reasons.most_common())
            + f"); of meshes with at least {COARSE} faces, these are of {', '.join(fine)}.")


def tips(rows):
    ends = grouped([row for row in rows if "tip" in row], "mesh", "tip").values()
    sizes = [[row["size"] for row in sorted(end, key=lambda row: row["amplitude"])] for end in ends]
    grow = count(sizes, lambda end: all(b > a for a, b in zip([1, *end], end)))
    widest = max(max(row["tip_high"], 1 / row["tip_low"]) for row in rows if "tip" in row)
    return (f"{grow} of {len(sizes)} ends point outward, and grow with A. At A = 3, lengths at the very end are "
            f"multiplied by {extent((end[-1] for end in sizes), '.2f')} (least / median / greatest); on 99.8 % of the "
            f"area by {widest:.2f} at most.")


def sweeps(rows):
    found = [row for row in rows if "jump" in row]
    return table(["of 100 amplitudes", "least / median / greatest"], [
        ["largest step, by the median of its ten neighbours", extent((row["jump"] for row in found), ".1f")],
        ["largest step, % of the diagonal", extent(100 * row["step"] for row in found)],
        ["retreat of the range of lengths, %", extent(100 * row["retreat"] for row in found)]])


def blocks(rows):
    some = cases(rows)
    return {"shares": share_table(some), "costs": cost_table(some), "refusals": refusals(some),
            "tips": tips(rows), "sweeps": sweeps(rows)}


def factor(row, prefix=""):
    """The largest by which lengths have changed, either way, on 98 % of the area."""
    return max(row[prefix + "high"], 1 / row[prefix + "low"]) if row[prefix + "low"] else 1e6


def bounds(rows):
    """surface, amplitude -> (bound, what is kept of rho)"""
    found = grouped([row for row in rows if row.get("bound")], "mesh", "amplitude")
    return {f"{mesh.removesuffix('.off')}, A = {a}": [(row["bound"], row["kept_norm"]) for row in some]
            for (mesh, a), some in found.items()}


def figures(rows):
    some = cases(rows)
    factors = {name: [min(factor(row, prefix), 100) for row in some]
               for name, prefix in (("without a bound", "plain_"), ("bound 2", ""))}
    return {"scale_control_lengths.svg": plot.distributions(
                factors, "largest factor of lengths (98 % of the area; 100 or more)", "What a bound on lengths does"),
            "scale_control_bounds.svg": plot.curves(bounds(rows), "bound on lengths", "norm of rho', by that of rho",
                                                    "What a tighter bound costs: six rings", log="")}
