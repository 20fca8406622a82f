# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The part of doc/branches.md about amplitudes, constants and spectra on single meshes."""

import statistics
import subprocess
import tempfile

from page import tables

MESHES = ["armadillo.off", "bear.off", "fandisk.off", "homer.off", "triceratops.off"]

COMMANDS = [
    "spin bear.off --rho-expression sin(5*y) --tolerance 1e300",
    "spin homer.off --rho-expression 3*sin(6*y) --max-scale none",
    "spin homer.off --rho-expression 3*sin(6*y)",
    "spin knot1.off --rho-expression x",
    "spin knot1.off --rho-expression x --min-realised 0.95",
    "sphere --kappa -40 --level 4",
    "sphere --kappa 3 --level 5",
    "spectrum homer.off --count 10 --surface 9",
]

TEXT = """\
## An amplitude as a slider

rho = A sin 5y for 40 amplitudes A up to 3, from what `benchmark_branch_cases` prints, at tolerance 1e-10. *Move* is the
distance of the positions to those of the amplitude before, *shifted* that to those for rho + 1; both are
roots of means over the area, relative to the diagonal of the mesh. *Jumps* are moves of more than 0.01 that are
more than four times the move before.

{sweeps}

## Mean distortion

Of the same results, with the number of flipped faces and the verdict:

{amplitudes}

## Eigenvalues next to a shift

The twelve eigenvalues of D nearest to shifts that are, or nearly are, eigenvalues themselves: on the unit sphere
through 3,000 points on a spiral, where all integers n but -1 are eigenvalues |n + 1| times, and on the torus of
radii 2 and 1 from 64 x 32 points, compared with its ordinary differential equations. *Error* is the distance
of a value to the nearest exact one, the largest of the twelve; *found* and *exact* count eigenvalues within
the window that is reported as complete, less 0.1.

{spectra}

## Verdicts

What the program says of requests that cannot be met, and of results that are not conformal, have collapsed, or are
not what was asked for: it exits with 2 or 1, and writes nothing.

{verdicts}

The convergence of edits on surfaces with handles is on the page [Surfaces with handles](handles.md), and so is
what makes the class of the twisted torus drift.
"""


def sweep_of(rows, mesh):
    return [row for row in rows if row.get("mesh") == mesh and "move" in row]


def sweep_line(mesh, rows):
    median = statistics.median(row["move"] for row in rows)
    jumps = [row for last, row in zip(rows, rows[1:])
             if row["move"] > max(0.01, 4 * last["move"])]
    return [mesh, f"{rows[0]['faces']:,}", str(len(rows)),
            str(sum(row["verified"] for row in rows)), f"{median:.4f}",
            f"{max(row['move'] for row in rows):.4f}", str(len(jumps)),
            f"{max(row['shifted'] for row in rows):.0e}",
            f"{statistics.mean(row['factorizations'] for row in rows):.2f}"]


def sweep_table(rows, meshes):
    header = ["mesh", "faces", "amplitudes", "verified", "move: median", "largest", "jumps",
              "shifted: largest", "factorizations: mean"]
    return tables.table(header, [sweep_line(mesh, sweep_of(rows, mesh)) for mesh in meshes])


def distortion(row):
    flips = f", {row['flips']} flipped" if row["flips"] else ""
    return f"{row['Q']:.4f}{flips}{'' if row['verified'] else ', refused'}"


def amplitude_table(rows, meshes):
    shown = [0.3, 0.6, 0.825, 0.975, 1.5, 2.025, 3]
    lines = [[mesh, *(distortion(row) for row in sweep_of(rows, mesh) if row["amplitude"] in shown)]
             for mesh in meshes]
    return tables.table(["mesh", *(f"A = {a}" for a in shown)], lines)


def spectrum_table(rows):
    header = ["surface", "shift", "complete within", "found", "exact", "error"]
    return tables.table(header, [
        [row["spectrum"], str(row["shift"]), f"{row['complete_radius']:.2f}", str(row["found"]),
         str(row["exact"]), f"{row['error']:.3f}"] for row in rows if "spectrum" in row])


def run_command(program, command, folder):
    with tempfile.TemporaryDirectory() as output:
        words = [str(folder / word) if word.endswith(".off") else word
                 for word in command.split()]
        run = subprocess.run([program, *words, "-q", "-o", f"{output}/result.ply"],
                             capture_output=True, text=True, check=False)
    reason = run.stderr.strip().splitlines()[-1:] if run.returncode else []
    words = "".join(reason).replace(f"{folder}/", "").removeprefix("conformal: error: ")
    return {"command": command, "code": run.returncode, "reason": words}


def verdicts(program, folder):
    return [run_command(program, command, folder) for command in COMMANDS]


def verdict_table(rows):
    header = ["command", "exit", "reason"]
    return tables.table(header, [[f"`{row['command']}`", str(row["code"]), row["reason"]]
                                 for row in rows if "command" in row])


def page(rows):
    meshes = [mesh for mesh in MESHES if sweep_of(rows, mesh)]
    return TEXT.format(sweeps=sweep_table(rows, meshes), amplitudes=amplitude_table(rows, meshes),
                       spectra=spectrum_table(rows), verdicts=verdict_table(rows))
