# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""doc/parts.md, from the record of benchmark/measure_parts."""

from page import plot
from page.tables import grouped, table


def measured(rows):
    return [row for row in rows if "faces" in row]


def name_of(processes):
    return "conformal spin" if processes == 0 else f"{processes} process{'es' if processes > 1 else ''}"


def cells(row, alone):
    """Of a row, and that of one process on the same mesh."""
    most = max(row["megabytes"])
    return [name_of(row["processes"]), f"{most:.0f}", f"{most / max(alone['megabytes']):.2f}",
            f"{sum(row['megabytes']) / max(alone['megabytes']):.2f}", f"{row['seconds']:.0f}", str(row["iterations"])]


def alone(rows):
    return [row for row in measured(rows) if row["processes"] == 1]


def largest_table(rows):
    last = alone(rows)[-1]
    return table([f"{last['faces']:,} faces", "MB, largest", "by that of 1", "sum, by that of 1", "CPU seconds",
                  "iterations"],
                 [cells(row, last) for row in measured(rows) if row["faces"] == last["faces"]])


def growth(rows):
    first, last = alone(rows)[0], alone(rows)[-1]
    return (f"From {first['faces']:,} to {last['faces']:,} faces, the iterations of one process go from "
            f"{first['iterations']} to {last['iterations']}.")


def large(rows):
    """Meshes that no run of one process is measured on."""
    known = {row["faces"] for row in alone(rows)}
    return " ".join(f"{row['mesh'].partition(',')[0]}, {row['faces']:,} faces on {name_of(row['processes'])}: "
                    f"{max(row['megabytes']):.0f} MB the largest, {sum(row['megabytes']) / 1024:.1f} GB together, "
                    f"{row['seconds']:.0f} CPU seconds in {row['wall'] / 60:.0f} minutes, "
                    f"{row['iterations']} iterations."
                    for row in measured(rows) if row["faces"] not in known)


def differences(rows):
    """The largest of all numbers of processes."""
    compared = grouped([row for row in rows if "compared" in row], "compared", "bound")
    return ", ".join(f"{name}{f' within {bound}' if bound else ''} {max(row['difference'] for row in some):.0e}"
                     for (name, bound), some in compared.items()) + "."


def blocks(rows):
    return {"parts": largest_table(rows), "growth": growth(rows), "large": large(rows),
            "differences": differences(rows)}


def figures(rows):
    lines = {name_of(n): [(row["faces"], max(row["megabytes"])) for row in some]
             for (n,), some in grouped(measured(rows), "processes").items()}
    return {"parts_memory.svg": plot.curves(lines, "faces", "MB of the largest process",
                                            "Peak memory of a spin transformation", ["conformal spin"])}
