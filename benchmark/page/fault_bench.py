# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""What the checks of benchmark/faults share: a generated mesh, runs, and counted violations."""

import os
import pathlib
import resource
import subprocess

from page import ply_points, sandbox

RHO = ["--rho-expression", "0.7*sin(4*y)"]
OLD = b"an old output, which is to stay as it is\n"
PATIENCE = 120  # seconds after which a run hangs


class Bench:
    """A program, a folder, and in it a sphere with the result of spin on it."""

    def __init__(self, program, folder, level):
        self.program = pathlib.Path(program)
        self.folder = pathlib.Path(folder)
        self.mesh = self.folder / "sphere.ply"
        self.check_run("sphere", "--kappa", "1", "--level", str(level), "-o", self.mesh)
        self.vertices = len(ply_points.points(self.mesh.read_bytes()))
        self.check_run(*self.spin(self.folder / "reference.ply"))
        self.reference = (self.folder / "reference.ply").read_bytes()

    def spin(self, output, mesh=None):
        return ["spin", mesh or self.mesh, *RHO, "-o", output]

    def command(self, *arguments):
        return [self.program, *arguments, "--quiet"]

    def check_run(self, *arguments):
        subprocess.run(self.command(*arguments), check=True, timeout=PATIENCE)

    def run(self, *arguments, patience=PATIENCE, **options):
        """(exit code or "hangs", the last line of stderr)"""
        try:
            done = subprocess.run(self.command(*arguments), stderr=subprocess.PIPE,
                                  timeout=patience, check=False,
                                  **{"stdout": subprocess.DEVNULL, **options})
        except subprocess.TimeoutExpired:
            return "hangs", ""
        return done.returncode, sandbox.last_error(done.stderr.decode("utf-8", "replace"))

    def new_folder(self, name):
        folder = self.folder / name
        folder.mkdir()
        return folder


class Check:
    """Counts tries and violations, and keeps the first violations and how runs ended."""

    def __init__(self, name):
        self.name, self.tries, self.violations, self.endings = name, 0, [], {}

    def ended(self, how):
        self.tries += 1
        self.endings[how] = self.endings.get(how, 0) + 1

    def expect(self, holds, violation):
        if not holds:
            self.violations.append(str(violation))

    def row(self, more=""):
        endings = ", ".join(f"{how}: {count}" for how, count in sorted(self.endings.items()))
        detail = "; ".join(filter(None, [endings, more, *self.violations[:5]]))
        return {"check": self.name, "tries": self.tries, "violations": len(self.violations),
                "detail": detail}


def is_whole(data, vertices):
    return not ply_points.fault(data, vertices)


def others(folder, *known):
    """The names of files in the folder that nobody asked for."""
    return sorted(set(os.listdir(folder)) - set(known))


def memory_limit(size):
    def apply():
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_AS, (size, size))
    return apply
