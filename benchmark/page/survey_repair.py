# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""What --repair makes of the meshes that the survey found unsuitable."""

from page import survey_outcome

WORDS = {"merged_points": "merged", "removed_faces": "bad faces", "turned_faces": "turned",
         "flipped_edges": "flips", "collapsed_edges": "collapses",
         "removed_flat_faces": "flat faces removed", "cut_edges": "edges cut",
         "added_vertices": "copies", "removed_vertices": "unused"}


def counts(report):
    """The numbers of a report's repair that are not zero."""
    return {name: report[name] for name in WORDS if report.get(name)}


def done(counted):
    """The same in words, of an object that has `repair`."""
    numbers = counts(counted.get("repair", {}))
    return ", ".join(f"{WORDS[name]} {count:,}" for name, count in numbers.items()) or "nothing"


def refused(rows):
    """The meshes with problems, by the record of the runs without --repair."""
    return {(row["set"], row["mesh"]) for row in rows
            if row["command"] == "info" and row.get("suitable") is False
            and row["outcome"] == survey_outcome.VERIFIED}


def is_of_components(problem):
    return "components" in problem


def summary(before, after):
    """How many had which problem, lost it, and were then verified."""
    meshes = refused(before)
    worse = {(row["set"], row["mesh"]) for row in before if row["command"] == "spin"
             and (row["set"], row["mesh"]) in meshes and not is_of_components(row["reason"])}
    left = {(row["set"], row["mesh"]): row["problems"] for row in after if row["command"] == "info"}
    still = sum(not all(map(is_of_components, problems)) for problems in left.values())
    fine = sum(not problems for problems in left.values())
    verified = sum(row["command"] == "spin" and row["outcome"] == survey_outcome.VERIFIED
                   for row in after)
    return (f"Of the {len(meshes)} meshes with a problem, {len(worse)} have another one than several "
            f"components;\nwith `--repair`, {still} have. {fine} have no problem at all then, and "
            f"`spin --repair` is verified on {verified} of them.")
