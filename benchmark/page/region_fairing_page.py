# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/region_fairing.md, from the record of benchmark/fair_region."""

import math

from page import plot
from page.tables import count, extent, table

PEERS, OURS = ["fair, continuity 1", "fair, continuity 2"], "conformal_fairing"
MEASURES = {"distance": "distance_mean", "jump of the normals": "jump_rms", "integral of H^2": "energy"}


def surfaces(rows, name):
    """surface -> method -> row"""
    found = {}
    for row in rows:
        if row["table"] == name:
            found.setdefault(row["surface"], {})[row["method"]] = row
    return found


def error(rows, surface, method=OURS):
    return surfaces(rows, "smooth")[surface][method]["distance_mean"]


def power(rows, name):
    """The slope of the mean distance over meshes that double."""
    errors = [error(rows, surface) for surface in surfaces(rows, "smooth") if surface.startswith(name)]
    return math.log2(errors[0] / errors[-1]) / (len(errors) - 1)


def smooth(rows):
    peers = " and ".join(f"{error(rows, 'sphere 64', peer):.1e}" for peer in PEERS)
    sphere, clifford = (power(rows, name) for name in ("sphere", "Clifford torus"))
    return "\n".join([
        f"- *Sphere*, everything above z = 0.2: the distance falls with the power {sphere:.2f} of the edge, to "
        f"{error(rows, 'sphere 64'):.1e}. With `fair()` it",
        f"  stays at {peers}: the linear equation has the angles of the flat filling.",
        f"- *Clifford torus*, the top within a distance of 1.1: power {clifford:.2f}. Curvatures at the rim have "
        "errors that",
        "  fall only in the mean.",
        "- The *torus* with radii 3 and 1 is no Willmore surface: the smoothest surface with that rim is another one, "
        "and the distance",
        f"  hardly falls, to {error(rows, 'torus 128'):.1e}."])


def scans(rows):
    holes = surfaces(rows, "scans").values()
    wins = {what: count(holes, lambda hole, key=key: all(hole[OURS][key] < hole[peer][key] for peer in PEERS))
            for what, key in MEASURES.items()}
    times = [hole[OURS]["seconds"] / hole[PEERS[0]]["seconds"] for hole in holes]
    return (f"Less than with `fair()` of either continuity, in {len(holes)} holes: "
            + ", ".join(f"{what} in {number}" for what, number in wins.items())
            + f". The time is {min(times):.0f} to {max(times):.0f} times that of continuity 1.")


def class_table(rows):
    found = [row for row in rows if row["method"] == "in class"]
    return table(["disks of the same meshes, faired within their class", "least / median / greatest"], [
        ["integral of H^2, by that before", extent(row["energy"] / row["energy_before"] for row in found)],
        ["Q mean", extent((row["q_mean"] for row in found), ".4f")],
        ["change of log cross-ratios, at most", extent((row["cross_ratio_max"] for row in found), ".0e")],
        ["flipped faces", extent((row["flips"] for row in found), ".0f")],
        ["steps", extent((row["steps"] for row in found), ".0f")]])


def blocks(rows):
    return {"smooth": smooth(rows), "scans": scans(rows), "in_class": class_table(rows)}


def figures(rows):
    lines = {}
    for surface, methods in surfaces(rows, "smooth").items():
        name, _, size = surface.rpartition(" ")
        for method in (OURS, PEERS[0]):
            lines.setdefault(f"{name}, {method.split('_')[0]}", []).append(
                (int(size), methods[method]["distance_mean"]))
    distances = {surface: {method: methods[method]["distance_mean"] for method in (OURS, *PEERS)}
                 for surface, methods in surfaces(rows, "scans").items()}
    return {"region_fairing_smooth.svg": plot.curves(
                lines, "edges around the equator, or the tube", "mean distance, by the diagonal of the hole",
                "Holes in surfaces whose answer is known"),
            "region_fairing_scans.svg": plot.dots(
                distances, "mean distance from the surface before", "Holes in scans, by vertex")}
