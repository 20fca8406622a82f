# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/loops_and_handles.md, from the record of benchmark/measure_loops_and_handles."""

from page import plot
from page.measurements import exponent
from page.tables import table

LEAST = {"loops": 20, "handles": 5}  # from where the exponents are fitted
OUTCOMES = {0: "verified", 1: "does not verify", 124: "stopped"}


def of_kind(rows, kind):
    return [row for row in rows if row["kind"] == kind]


def table_of(rows, kind):
    return table([kind, "CPU s", "MB", "kept of rho", "result"], [
        [str(row["count"]), f"{row['seconds']:.2f}", f"{row['kilobytes'] / 1024:.0f}",
         f"{100 * (row.get('realised_share') or 0):.0f} %", OUTCOMES.get(row["code"], "refused")]
        for row in of_kind(rows, kind)])


def exponent_of(rows, kind, key, least):
    some = [row for row in of_kind(rows, kind) if row["count"] >= least]
    return exponent([row["count"] for row in some], [row[key] for row in some])


def exponents(rows):
    texts = []
    for kind, least in LEAST.items():
        time, memory = (exponent_of(rows, kind, key, least) for key in ("seconds", "kilobytes"))
        texts.append(f"From {least} {kind} on, time grows with the power {time:.2f} of their number, "
                     f"memory with the power {memory:.2f}.")
    return " ".join(texts)


def blocks(rows):
    return {"exponents": exponents(rows), "loops": table_of(rows, "loops"), "handles": table_of(rows, "handles")}


def figures(rows):
    lines = {kind: [(row["count"], row["seconds"]) for row in of_kind(rows, kind) if row["count"] > 0]
             for kind in LEAST}
    return {"loops_and_handles.svg": plot.curves(lines, "number", "seconds of the processor",
                                                 "Cost of spin by the number of loops or handles")}
