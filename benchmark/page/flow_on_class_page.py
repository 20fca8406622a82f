# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/flow_on_class.md, from the record of benchmark/flow_on_class."""

import math

from page import plot
from page.tables import count, table

SPHERE = 4 * math.pi
OPPONENTS = ("cMCF", "smooth_shape")
GROUPS = {"CGAL": "CGAL's data", "slivers": "slivers"}
LAW = 0.95  # no opponent has less of both energy and Q than so much of ours


def of_table(rows, name):
    return [row for row in rows if row["table"] == name]


def exact(rows):
    return {row["mesh"]: row for row in of_table(rows, "flow") if row["flow"] == "exact" and "energy" in row}


def flow_table(rows):
    """Of the flow on the class, a row a mesh; its energy beside that of the flow of the thesis."""
    plain = {row["mesh"]: row for row in of_table(rows, "flow") if row["flow"] == "plain"}
    lines = []
    for mesh, row in exact(rows).items():
        lines.append([mesh, str(row["genus"]), f"{row['energy_before']:.3f}", f"{row['energy']:.4f}",
                      f"{plain[mesh]['energy']:.3f}", f"{row['q_mean']:.4f}",
                      f"{row['cross_ratio']:.1e}", "yes" if not row["outcome"].startswith("exit") else "no"])
    return table(["mesh", "genus", "E before", "E", "plain", "Q mean", "cross-ratios", "verified"],
                 lines)


def duels(rows):
    """mesh -> method -> row, of meshes with a result."""
    found = {}
    for row in of_table(rows, "faces"):
        if row.get("q_mean"):
            found.setdefault(row["mesh"], {})[row["method"]] = row
    return found


def by(row, ours):
    """At most so much of ours that another one has of both."""
    return max(row["energy"] / ours["energy"], row["q_mean"] / ours["q_mean"])


def beats(duel, name):
    return name in duel and by(duel[name], duel["flow"]) < LAW


def keeps_law(duel):
    return not any(beats(duel, name) for name in OPPONENTS)


def is_beyond_limits(row):
    return not (row["q_mean"] <= 1.5 and row["flips"] <= .01 * row["faces"])


def median(values):
    values = sorted(values)
    return values[len(values) // 2]


def medians(rows):
    return [f"{median([row[key] / unit for row in rows]):.4g}"
            for key, unit in (("energy", SPHERE), ("q_mean", 1), ("q_max", 1))]


def group_table(rows):
    """On the faces of the files: ours and the opponents, and how often one has less of both E and Q."""
    lines = []
    for group, name in GROUPS.items():
        some = [duel for duel in duels(rows).values() if duel["flow"]["group"] == group]
        for method in ("flow", *OPPONENTS):
            found = [duel[method] for duel in some if method in duel]
            if not found:
                continue
            spheres = [row for row in found if row["genus"] == 0]
            better = "" if method == "flow" else str(sum(beats(duel, method) for duel in some))
            lines.append([name, method, str(len(found)), *medians(spheres),
                          str(sum(row["flips"] for row in found)), better])
    return table(["meshes", "by", "number", "genus 0: E", "Q mean", "Q max", "flips", "better in both"], lines)


def verdicts(rows):
    ours = [duel["flow"] for duel in duels(rows).values()]
    verified = [row for row in ours if row["code"] == 0]
    kept = count(duels(rows).values(), keeps_law)
    growth = [duel["flow"]["energy"] / duel["before"]["energy"] - 1 for duel in duels(rows).values()]
    rise = max(row.get("rise", 0) for row in ours)
    return (f"The law is kept on {kept} of {len(ours)} meshes. Exit 0: {len(verified)}, of which "
            f"{count(verified, is_beyond_limits)} are beyond a limit of Q or flips. E has grown on "
            f"{sum(value > 0 for value in growth)}, by {max(0, *growth):.1%} at most, in steps after the "
            f"least by {rise:.2%}.")


def broken_table(rows):
    """Of the meshes where an opponent is better in both: E, and the mean of Q."""
    methods = ("flow", *OPPONENTS)
    lines = [[mesh, *(f"{duel[method]['energy'] / SPHERE:.3f}, {duel[method]['q_mean']:.3f}" if method in duel else ""
                      for method in methods)] for mesh, duel in duels(rows).items() if not keeps_law(duel)]
    return table(["mesh", *methods], lines) if lines else "None."


def handles_table(rows):
    lines = [[f"{row['mesh']}, {row['faces']:,} faces", str(row["genus"]), f"{row['seconds']:.2f}",
              *(f"{row[key]:.1f}" for key in ("step", "late_step"))]
             for row in of_table(rows, "cost") if row.get("genus", 0) > 0]
    return table(["mesh", "genus", "CPU s", "P a step", "late"], lines)


def blocks(rows):
    return {"flows": flow_table(rows), "groups": group_table(rows), "verdicts": verdicts(rows),
            "broken": broken_table(rows), "handles": handles_table(rows)}


def costs(rows):
    names = {"step": "a step, mean", "worst_step": "the worst", "late_step": "a late one", "construction": "before all",
             "finish": "after all"}
    return {row["mesh"]: {name: row[key] for key, name in names.items() if key in row}
            for row in of_table(rows, "cost")}


def figures(rows):
    kept = {row["mesh"]: {} for row in of_table(rows, "flow")}
    for row in of_table(rows, "flow"):
        kept[row["mesh"]][{"exact": "on the class", "plain": "as in the thesis"}[row["flow"]]] = row["cross_ratio"]
    nearest = {f"{method}, {GROUPS[group]}": [by(duel[method], duel["flow"]) for duel in duels(rows).values()
                                            if method in duel and duel["flow"]["group"] == group]
               for method in OPPONENTS for group in GROUPS}
    return {"flow_on_class_opponents.svg": plot.distributions(
                {name: [min(value, 10) for value in some] for name, some in nearest.items()},
                "larger of E and Q by those of the flow, where that is least; 10 or more",
                "How near others come", what="meshes"),
            "flow_on_class_ratios.svg": plot.dots(
                kept, "largest change of log cross-ratios", "How well the class is kept"),
            "flow_on_class_costs.svg": plot.dots(costs(rows), "multiples of P", "What a step costs")}
