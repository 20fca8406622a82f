# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""What the programs doc/draw_* share: their options, CGAL's meshes, running an example, and drawing
surfaces side by side, all with the camera, the lamp and the colours of examples/render."""

import argparse
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FIGURES = ROOT / "doc" / "figures"
sys.path += [str(ROOT / "benchmark"), str(ROOT / "test" / "tools")]

import check_example  # noqa: E402
from page import cgal_data  # noqa: E402

write_off = check_example.write_off


class Studio:
    """Where the programs are, and where their results go."""

    def __init__(self, options):
        self.build, self.work, self.folder = options.build_dir, options.work, options.data
        self.work.mkdir(parents=True, exist_ok=True)

    def mesh(self, name):
        """One of the meshes of Debian's package libcgal-demo."""
        self.folder = self.folder or cgal_data.unpack(self.work)
        return self.folder / name

    def run(self, program, *arguments):
        """What the program prints."""
        run = subprocess.run([self.build / "examples" / program, *map(str, arguments)], check=True,
                             stdout=subprocess.PIPE, text=True)
        print(run.stdout, end="")
        return run.stdout

    def certify(self, figure, program, *arguments):
        """Runs the program, and keeps what it says in the end beside the figure."""
        certificate = self.run(program, *arguments).rpartition("\n\n")[2]
        (FIGURES / f"{figure}.txt").write_text(certificate, encoding="utf-8")


def render(surfaces, picture, view=""):
    """Surfaces of the same connectivity side by side; `view` are options of examples/render."""
    subprocess.run([ROOT / "examples" / "render", *surfaces, picture, *view.split()], check=True)


def draw(description, figures):
    """Draws those of the figures (name -> function of a `Studio`) that the command line names."""
    parser = argparse.ArgumentParser(description=description.partition("\n\n")[0])
    parser.add_argument("figures", nargs="*", metavar="FIGURE",
                        help=f"some of {', '.join(figures)} [all]")
    parser.add_argument("--build-dir", type=pathlib.Path, default=ROOT / "build",
                        help="where the examples are built [build]")
    parser.add_argument("--data", type=pathlib.Path,
                        help="meshes of Debian's package libcgal-demo [unpacked from there]")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build/figures",
                        help="for everything but the figures [build/figures]")
    options = parser.parse_args()
    unknown = set(options.figures) - set(figures)
    if unknown:
        parser.error(f"no figure is called {', '.join(sorted(unknown))}")
    studio = Studio(options)
    for name in options.figures or figures:
        figures[name](studio)
