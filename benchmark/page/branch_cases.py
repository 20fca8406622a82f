# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Verdicts of `conformal` on single meshes, for doc/branches.md."""

import subprocess
import tempfile

MESHES = ["armadillo.off", "bear.off", "fandisk.off", "homer.off", "triceratops.off"]

COMMANDS = [
    "spin bear.off --rho-expression sin(5*y) --advanced tolerance=1e300",
    "spin homer.off --rho-expression 3*sin(6*y) --max-scale none",
    "spin homer.off --rho-expression 3*sin(6*y)",
    "spin knot1.off --rho-expression x",
    "spin knot1.off --rho-expression x --limit realised_share=0.95",
    "sphere --kappa -40 --level 4",
    "sphere --kappa 3 --level 5",
    "spectrum homer.off --count 10 --surface 9",
]


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
