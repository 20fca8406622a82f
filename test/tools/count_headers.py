#!/usr/bin/env python3
# Copyright (c) 2026 The Conformal Geometry Processing authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Counts the headers with executed lines in one spin transformation of a sphere.

usage: count_headers.py [FOLDER]

Compiles a program of one transformation header-only with g++ --coverage in FOLDER (a temporary
one by default), runs it, and asks gcov which lines of which headers ran.
"""

import gzip
import json
import pathlib
import subprocess
import sys
import tempfile

import sources

PROGRAM = """
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/surfaces/geodesic_sphere.h>
namespace CGP = Conformal_geometry_processing;
int main()
{
  const CGP::Mesh_view mesh = CGP::geodesic_sphere(8);
  const Eigen::VectorXd rho = mesh.positions().row(0).array().sin().matrix().transpose();
  const auto result =
      CGP::Spin_transformation<>(mesh).transform(CGP::Curvature_potential::on_vertices(rho));
  return result.report ? 0 : 1;
}
"""


def executed(folder):
    """The library's headers with at least one executed line, by folder of the library."""
    (folder / "one.cpp").write_text(PROGRAM)
    flags = ["-std=c++17", "-O0", "--coverage", "-DCONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY",
             f"-I{sources.INCLUDE.parent}", "-isystem", "/usr/include/eigen3", "-pthread"]
    subprocess.run(["g++", *flags, "one.cpp", "-o", "one"], cwd=folder, check=True)
    subprocess.run(["./one"], cwd=folder, check=True)
    notes = next(folder.glob("*.gcno"))
    subprocess.run(["gcov", "--json-format", notes.name], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)
    headers = set()
    for path in folder.glob("*.gcov.json.gz"):
        for file in json.loads(gzip.decompress(path.read_bytes()))["files"]:
            name = pathlib.Path(file["file"])
            if sources.LIBRARY in name.parts and any(line["count"] for line in file["lines"]):
                headers.add("/".join(name.parts[name.parts.index(sources.LIBRARY) + 1:]))
    return headers


def main():
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else temporary)
        headers = executed(folder)
    # X.h, X_impl.h and X_templates.h are one header in three parts.
    headers = {h.replace("_impl.h", ".h").replace("_templates.h", ".h") for h in headers}
    folders = {}
    for header in sorted(headers):
        folders.setdefault(header.rpartition("/")[0], []).append(header)
    for name, of_folder in folders.items():
        print(f"| `{name}/` | {len(of_folder)} |")
    print(f"| all | {len(headers)} |")


if __name__ == "__main__":
    main()
