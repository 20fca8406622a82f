# Copyright (c) 2026 The Conformal Geometry Processing authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/mutations.md: which broken formulas the tests notice."""

import json

from page.tables import table

INTRODUCTION = """# Do the tests notice a wrong formula?

Written by `benchmark/mutate`, which breaks the headers of `operators/`, `spin/` and `flow/` in one place at a
time: a sign, a factor, a root, a conjugation, a division. A mutant is *killed* if the tests of its header, or
those of the results of its folder, fail, end early or do not end. One that does not compile is not counted.
Mutants are drawn by lot, and a run goes on where the last one was stopped: the table counts those judged so far.
"""

def is_killed(record):
    return record["outcome"] in ("fails", "ends early", "does not end")


def score_table(records):
    rows = []
    for name in [*sorted({r["header"].split("/")[0] for r in records}), "all"]:
        some = [r for r in records if name in ("all", r["header"].split("/")[0])
                and r["outcome"] != "does not compile"]
        killed = sum(map(is_killed, some))
        rows.append([f"`{name}`" if name != "all" else name, str(len(some)), str(killed),
                     f"{100 * killed / max(1, len(some)):.1f} %"])
    return table(["headers", "mutants", "killed", "score"], rows)


def survivor_list(records):
    lines = []
    for r in sorted(records, key=lambda r: (r["header"], r["line"])):
        if r["outcome"] == "survived":
            lines.append(f"- `{r['header']}`, {r['what']}: `{r['before']}` as `{r['after']}`")
    return "\n".join(lines) or "None."


def write(folder, record_file):
    records = [json.loads(line) for line in record_file.read_text(encoding="utf-8").splitlines()]
    text = "\n".join([INTRODUCTION, score_table(records), "", "## Survivors", "",
                      survivor_list(records), ""])
    (folder / "mutations.md").write_text(text, encoding="utf-8")
