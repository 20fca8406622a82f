# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Writes doc/survey.md from the records of benchmark/survey and benchmark/faults."""

import collections
import json
import shlex

from page import machine, survey_outcome, survey_repair, tables
from page.survey_outcome import (BAD, CRASHED, GOOD, NOT_VERIFIED, TIMED_OUT, UNREADABLE,
                                 UNSUITABLE, VERIFIED)

RECORD = machine.ROOT / "doc" / "survey.jsonl"
REPAIRED = machine.ROOT / "doc" / "survey_repair.jsonl"
FAULTS = machine.ROOT / "doc" / "faults.jsonl"
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
LETTERS = {VERIFIED: "✓", UNSUITABLE: "4", UNREADABLE: "3", NOT_VERIFIED: "1",
           CRASHED: "CRASH", TIMED_OUT: "TIME"}



def command_line(command, mesh, *more):
    """The words after `conformal`, of a command that may have options in its name."""
    verb, *options = command.split()
    return [verb, str(mesh), *COMMANDS[command], *options, *more]


TEXT = """\
# A survey: what becomes of any mesh

Written by `benchmark/survey` (from its record `survey.jsonl`) and `benchmark/faults` (`faults.jsonl`).
Each command runs on every mesh as it is, in an empty folder, within limits of the processor's time and
of memory. A run is *verified* where the exit code is 0, the report has a verified certificate (of
`info`: it is complete, of `harmonic`: residuals below {small:g}), and the output has as many vertices
as the mesh, all finite, read by other code than that which wrote it. It is *refused* where the exit
code is 3 (*cannot read*), 4 (*unsuitable*) or 1 (*not verified*: computed, and not good enough to be
written), with a reason, and no file is left. All the rest is a fault of the program.

{commands}

Of the runs on surfaces that `info` finds without a problem (one component, manifold, oriented):

{suitable}

## By command

{summary}

{faults}

## Reasons

How often which reason is given; N are numbers, and what is in parentheses is left out.

{reasons}

## With --repair

{repaired}

The columns tell why `spin` refused the mesh, what `--repair` did (and the report has, with the new
number of every vertex and face), which problems are left, and what became of the commands, as below.
Each kind of damage alone is in [damaged meshes](damage.md).

{repairs}

## Interrupts, limits and bad outputs

Written by `benchmark/faults`: how often a check was tried, how often it did not hold, how the runs
ended, and the first violations. An exit below 0 is death by that signal; of SIGTERM in the first
milliseconds, before the program listens to it, that is as it should be. *Not loaded*: the system could
not load the libraries, and the program never ran.

{checks}

## By mesh

✓ is verified; 1 (not verified), 3 (cannot read) and 4 (unsuitable) are refused, by exit code.

{meshes}
"""


def rows(path):
    if not path.exists():
        return []
    return [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()]


def summary(found):
    names = GOOD + [name for name in BAD if any(row["outcome"] == name for row in found)]
    counts = collections.Counter((row["command"], row["outcome"]) for row in found)
    lines = []
    for command in COMMANDS:
        numbers = [counts[command, name] for name in names]
        bad = sum(counts[command, name] for name in BAD)
        lines.append([f"`{command}`", str(sum(numbers)), *map(str, numbers), str(bad)])
    return tables.table(["command", "runs", *names, "faults"], lines)


def suitable_table(found, facts):
    """How many of the suitable surfaces are done, where the command has something to do."""
    always = {command: lambda mesh: True for command in COMMANDS if command.startswith("spin")}
    meant = {**always, "flow": lambda mesh: True,
             "boundary": lambda mesh: mesh["loops"], "flatten": lambda mesh: mesh["loops"],
             "harmonic": lambda mesh: mesh["genus"] and not mesh["loops"]}
    lines = []
    for command, is_meant in meant.items():
        runs = [row["outcome"] for row in found if row["command"] == command
                for mesh in [facts[row["set"], row["mesh"]]] if mesh["suitable"] and is_meant(mesh)]
        share = 100 * runs.count(VERIFIED) / len(runs) if runs else 0
        lines.append([f"`{command}`", str(len(runs)), str(runs.count(VERIFIED)), f"{share:.1f} %"])
    return tables.table(["command", "surfaces", "verified", "share"], lines)


def fault_list(found):
    lines = [f"- `{row['command']}` on {row['set']}'s {row['mesh']}: **{row['outcome']}**, "
             f"{row['reason']}" for row in found if row["outcome"] in BAD]
    return "\n".join(["Faults:", "", *lines]) if lines else "No run was a fault."


def reason_table(found):
    counts = collections.Counter()
    example = {}
    for row in found:
        if row["outcome"] != VERIFIED and row["outcome"] in GOOD:
            key = (row["outcome"], survey_outcome.kind(row["reason"]))
            counts[key] += 1
            example.setdefault(key, f"`{row['command']}` {row['mesh']}")
    lines = [[key[1].replace("|", "/"), key[0], str(number), example[key]]
             for key, number in sorted(counts.items(), key=lambda item: (item[0][0], -item[1]))]
    return tables.table(["reason", "outcome", "runs", "first"], lines)


def mesh_table(found, facts):
    cells = {(row["set"], row["mesh"], row["command"]):
             LETTERS.get(row["outcome"], row["outcome"]) for row in found}
    lines = []
    for (name, mesh), info in facts.items():
        counts = ["" if info.get(key) is None else f"{info[key]:,}"
                  for key in ("vertices", "faces", "genus", "loops")]
        lines.append([f"{name}: {mesh}", *counts,
                      *(cells.get((name, mesh, command), "") for command in COMMANDS)])
    return tables.table(["mesh", "vertices", "faces", "genus", "loops", *COMMANDS], lines)


def check_table():
    lines = [[row["check"], str(row["tries"]), str(row["violations"]), row["detail"]]
             for row in rows(FAULTS)]
    return tables.table(["check", "tries", "violations", "what happened"],
                        lines) if lines else "Not measured."


def write():
    found = rows(RECORD)
    facts = {(row["set"], row["mesh"]): row for row in found if row["command"] == "info"}
    called = "\n".join("- ``" + shlex.join(["conformal", *command_line(name, "MESH")]) + "``"
                       for name in COMMANDS)
    repaired = rows(REPAIRED)
    text = TEXT.format(repaired=survey_repair.summary(found, repaired),
                       repairs=survey_repair.table(found, repaired, LETTERS, list(COMMANDS)),
                       small=survey_outcome.SMALL, commands=called,
                       summary=summary(found), suitable=suitable_table(found, facts),
                       faults=fault_list(found), reasons=reason_table(found),
                       checks=check_table(), meshes=mesh_table(found, facts))
    (machine.ROOT / "doc" / "survey.md").write_text(text, encoding="utf-8")
