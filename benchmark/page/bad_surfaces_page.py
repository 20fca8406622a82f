# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Writes doc/bad_surfaces.md from the record of benchmark/survey_bad_surfaces."""

import collections
import json
import shlex

from page import machine, survey_page, tables
from page.survey_outcome import BAD, GOOD, VERIFIED

RECORD = machine.ROOT / "doc" / "bad_surfaces.jsonl"
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
KINDS = {
    "union": "unions of two to four solids, cut along the curves in which they meet",
    "vessel": "vessels with walls of 1e-4 to 1e-1 of the size, cut likewise",
    "extrusion": "stars of 3 to 120 corners, of heights 1e-2 to 30, with triangulated caps",
    "scan": "balls and tori with waves, noise up to an edge length, and crowded vertices",
    "open": "any of the kinds before, cut by a plane",
    "decimated": "any of these, with 10 to 60 % of their edges left",
    "snapped": "any of these, on a grid of 8 to 12 bits",
    "single": "any of these, as binary STL in single precision"}

TEXT = """\
# Badly shaped surfaces

Written by `benchmark/survey_bad_surfaces` from its record `bad_surfaces.jsonl`.
`benchmark_bad_surfaces` makes {number} surfaces as CAD programs and scanners do, always the same: {kinds}.
Each command runs on each of them as it is, in an empty folder, within {seconds} seconds of the
processor and 4 GiB. What the words mean is told in [the survey of public meshes](survey.md).

{commands}

Of the {number} surfaces {suitable} are one oriented manifold component without faces of area
zero; their least angles are {angles}. **{faults}** The longest run took {longest}, the largest {largest}.

## By command

{by_command}

## By kind

How many runs verified, of how many surfaces without a problem; then the longest time and the
largest memory of any run of the kind.

{by_kind}

## Reasons

How often which reason is given; N are numbers, and what is in parentheses is left out.

{reasons}
"""


def rows():
    return survey_page.rows(RECORD)


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


def cost(found):
    """The longest time and the largest memory."""
    return [f"{max(row['seconds'] for row in found):.1f} s",
            f"{max(row['memory'] for row in found):,} MiB"]


def by_command(found):
    names = [name for name in GOOD + BAD if any(row["outcome"] == name for row in found)]
    lines = []
    for command in COMMANDS:
        own = [row for row in found if row["command"] == command]
        counts = collections.Counter(row["outcome"] for row in own)
        lines.append([f"`{command}`", *(str(counts[name]) for name in names), *cost(own)])
    return tables.table(["command", *names, "longest", "largest"], lines)


def by_kind(found, suitable):
    names = [name for name in COMMANDS if name != "info"]
    lines = []
    for name in KINDS:
        own = [row for row in found if kind(row) == name]
        good = {row["mesh"] for row in own} & suitable
        verified = collections.Counter(row["command"] for row in own
                                       if row["mesh"] in good and row["outcome"] == VERIFIED)
        lines.append([name, str(len(good)), *(str(verified[command]) for command in names),
                      *cost(own)])
    return tables.table(["kind", "surfaces", *(f"`{name}`" for name in names), "longest",
                         "largest"], lines)


def angles(infos):
    found = sorted(row["least_angle"] for row in infos if row["least_angle"] is not None)
    return f"{found[0]:.1g} to {found[-1]:.0f} degrees, {found[len(found) // 2]:.1g} in the median"


def faults(found):
    bad = [row for row in found if row["outcome"] in BAD]
    if not bad:
        return f"None of {len(found):,} runs was a fault."
    return f"{len(bad)} of {len(found):,} runs are faults: " + "; ".join(
        f"`{row['command']}` on {row['mesh']}: {row['outcome']}, {row['reason']}"
        for row in bad) + "."


def write():
    found = rows()
    infos = [row for row in found if row["command"] == "info"]
    suitable = {row["mesh"] for row in infos if row["suitable"]}
    longest, largest = cost(found)
    called = "\n".join("- `" + shlex.join(["conformal", *command_line(name, MESH)]) + "`"
                       for name in COMMANDS)
    text = TEXT.format(
        number=len(infos), kinds="; ".join(f"*{name}*, {what}" for name, what in KINDS.items()),
        seconds=60, commands=called, suitable=len(suitable), angles=angles([row for row in infos if row["suitable"]]),
        faults=faults(found), longest=longest, largest=largest, by_command=by_command(found),
        by_kind=by_kind(found, suitable), reasons=survey_page.reason_table(found))
    (machine.ROOT / "doc" / "bad_surfaces.md").write_text(text, encoding="utf-8")
