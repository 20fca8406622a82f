# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/survey.md, from the records of benchmark/survey and benchmark/faults."""

import collections

from page import plot, record, survey_outcome, survey_repair
from page.survey_outcome import BAD, COLORS, GOOD, VERIFIED
from page.tables import table

COMMANDS = {
    "info": [],
    "spin": ["--rho-expression", "0.7*sin(4*y)"],
    "spin --mollify=0": ["--rho-expression", "0.7*sin(4*y)"],
    "spin --mollify": ["--rho-expression", "0.7*sin(4*y)"],
    "flow": ["--steps", "3"],
    "boundary": ["--binormal-tilt", "10*cos(2*pi*s)"],
    "flatten": [],
    "harmonic": [],
}
ALWAYS = ("spin", "spin --mollify=0", "spin --mollify", "flow")  # have something to do


def command_line(command, mesh, *more):
    """The words after `conformal`, of a command that may have options in its name."""
    verb, *options = command.split()
    return [verb, str(mesh), *COMMANDS[command], *options, *more]


def is_meant(command, mesh):
    """Whether the command has something to do on a mesh without problems."""
    if command == "harmonic":
        return mesh["genus"] and not mesh["loops"]
    return mesh["loops"] if command in ("boundary", "flatten") else command in ALWAYS


def suitable(found):
    """command -> outcome -> how many, of the runs on surfaces that the command is meant for."""
    facts = {(row["set"], row["mesh"]): row for row in found if row["command"] == "info"}
    return {command: collections.Counter(
        row["outcome"] for row in found if row["command"] == command
        for mesh in [facts[row["set"], row["mesh"]]] if mesh["suitable"] and is_meant(command, mesh))
            for command in COMMANDS if command != "info"}


def suitable_table(found):
    return table(["command", "surfaces", "verified", "share"], [
        [f"`{command}`", str(counts.total()), str(counts[VERIFIED]),
         f"{100 * counts[VERIFIED] / max(1, counts.total()):.1f} %"]
        for command, counts in suitable(found).items()])


def counted(found):
    """command -> outcome -> how many"""
    return {command: {name: count for name in GOOD + BAD
                      if (count := sum((row["command"], row["outcome"]) == (command, name) for row in found))}
            for command in dict.fromkeys(row["command"] for row in found)}


def fault_list(found):
    lines = [f"- `{row['command']}` on {row['mesh']}: **{row['outcome']}**, {row['reason']}"
             for row in found if row["outcome"] in BAD]
    return "\n".join(lines) or f"No run of {len(found):,} was a fault."


def reason_table(found, most=5):
    """The most frequent reasons of results that do not verify."""
    counts = collections.Counter(survey_outcome.kind(row["reason"]) for row in found
                                 if row["outcome"] == survey_outcome.NOT_VERIFIED)
    return table(["reason", "runs"], [[reason.replace("|", "/"), str(count)]
                                      for reason, count in counts.most_common(most)])


def check_table():
    return table(["check", "tries", "violations"], [[row["check"], str(row["tries"]), str(row["violations"])]
                                                    for row in record.load("faults")])


def blocks(found):
    return {"suitable": suitable_table(found), "faults": fault_list(found), "reasons": reason_table(found),
            "repaired": survey_repair.summary(found, record.load("survey_repair")), "checks": check_table()}


def figures(found):
    return {"survey.svg": plot.bars(counted(found), "Runs on public meshes", COLORS)}
