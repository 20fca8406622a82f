# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/mutations.md: which broken formulas the tests notice, and why the others may live."""

import json
import pathlib

from page.tables import table

INTRODUCTION = """# Do the tests notice a wrong formula?

Written by `benchmark/mutate`, which breaks the files of `operators/`, `spin/` and `flow/` in one place at a
time: a sign, a factor, a root, a conjugation, a division. A mutant is *killed* if a test that comes past it
fails, ends early or does not end. All mutants are compiled into one copy of the files, and the environment
chooses one, so that each test is compiled once; which line a test comes past is noted in a run without mutants.
The tests are those of the three folders; of those that come past a mutant, the quickest
are run, which take {seconds:g} seconds together without it.
"""

SURVIVORS = """
## Survivors

Most decide when a search goes on, not what it finds: whatever it finds is certified afterwards by the residual,
the gap and the sign of the eigenvalue, which are formulas of their own.
"""

REASONS = pathlib.Path(__file__).with_name("mutation_reasons.json")


def is_killed(record):
    return record["outcome"] in ("fails", "ends early", "does not end")


def score_table(records, waiting):
    rows = []
    for name in [*sorted({r["header"].split("/")[0] for r in records}), "all"]:
        some = [r for r in records if name in ("all", r["header"].split("/")[0])]
        killed = sum(map(is_killed, some))
        left = sum(waiting.values()) if name == "all" else waiting[name]
        rows.append([f"`{name}`" if name != "all" else name, str(len(some)), str(killed),
                     f"{100 * killed / max(1, len(some)):.1f} %", str(left)])
    return table(["headers", "mutants", "killed", "score", "not judged yet"], rows)


def survivor_list(records):
    """Two lines for each: what is changed, and the reason, which is written by hand."""
    reasons = json.loads(REASONS.read_text(encoding="utf-8"))
    lines = []
    for r in sorted(records, key=lambda r: (r["header"], r["line"])):
        if not is_killed(r):
            reason = reasons.get(f"{r['header']}: {r['after']}", "Not looked into yet.")
            lines.append(f"- `{r['header']}`, {r['what']}: `{r['before']}` as `{r['after']}`.\n  {reason}")
    return "\n".join(lines) or "None."


def write(folder, record_file, seconds, waiting):
    """waiting: how many of a folder have not been judged"""
    records = [json.loads(line) for line in record_file.read_text(encoding="utf-8").splitlines()]
    text = "\n".join([INTRODUCTION.format(seconds=seconds), score_table(records, waiting), SURVIVORS,
                      survivor_list(records), ""])
    (folder / "mutations.md").write_text(text, encoding="utf-8")
