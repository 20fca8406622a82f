# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/bad_surfaces.md, from the record of benchmark/survey_bad_surfaces."""

import collections

from page import plot
from page.survey_outcome import COLORS, VERIFIED
from page.survey_page import counted, fault_list, reason_table
from page.tables import table

MESH = "MESH"  # in a command, the name of the file
COMMANDS = {
    "info": [MESH],
    "spin": [MESH, "--rho-expression", "0.7*sin(4*y)"],
    "spin --max-scale none": [MESH, "--rho-expression", "0.7*sin(4*y)"],
    "flow": [MESH, "--steps", "3"],
    "boundary": [MESH, "--binormal-tilt", "10*cos(2*pi*s)"],
    "flatten": [MESH],
    "harmonic": [MESH],
    "spectrum": [MESH, "--count", "4"],
    "fit": [MESH, MESH],
    "blend": [MESH, MESH, "--t", "1"],
}


def facts(report):
    result = report.get("result", {})
    return {"faces": report.get("input", {}).get("faces"),
            "least_angle": result.get("min_angle"), "suitable": result.get("problems") == []}


def command_line(command, path):
    """The words after `conformal`, of a command that may have options in its name."""
    verb, *more = command.split()
    return [verb, *(path if word == MESH else word for word in COMMANDS[command]), *more]


def kind(row):
    return row["mesh"].split("_")[0]


def kind_table(found):
    """How many runs verified, of how many surfaces without a problem."""
    suitable = {row["mesh"] for row in found if row["command"] == "info" and row["suitable"]}
    names = [name for name in COMMANDS if name != "info"]
    lines = []
    for name in dict.fromkeys(map(kind, found)):
        verified = collections.Counter(row["command"] for row in found if kind(row) == name
                                       and row["mesh"] in suitable and row["outcome"] == VERIFIED)
        surfaces = sum(mesh.startswith(name) for mesh in suitable)
        lines.append([name, str(surfaces), *(str(verified[command]) for command in names)])
    return table(["kind", "surfaces", *(f"`{name}`" for name in names)], lines)


def summary(found):
    infos = [row for row in found if row["command"] == "info"]
    angles = sorted(row["least_angle"] for row in infos if row["suitable"])
    longest, largest = (max(row[key] for row in found) for key in ("seconds", "memory"))
    return (f"Of {len(infos)} surfaces {len(angles)} are one oriented manifold component without faces of area zero; "
            f"their least angles are {angles[0]:.1g} to {angles[-1]:.0f} degrees, {angles[len(angles) // 2]:.1g} in "
            f"the median. The longest run took {longest:.1f} s, the largest {largest:,} MiB. **{fault_list(found)}**")


def blocks(found):
    return {"summary": summary(found), "kinds": kind_table(found), "reasons": reason_table(found)}


def figures(found):
    return {"bad_surfaces.svg": plot.bars(counted(found), "Runs on badly shaped surfaces", COLORS)}
