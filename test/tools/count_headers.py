# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Counts the modules and headers of which lines are executed in one spin transformation of a sphere: compiles it
header-only with g++ --coverage, runs it, and asks gcov which lines of which files ran."""

import collections
import gzip
import json
import pathlib
import re
import subprocess

import header_only
import sources

PROGRAM = """
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Conformal_geometry_processing/surfaces/spheres.h>
namespace CGP = Conformal_geometry_processing;
int main()
{
  const CGP::Mesh_view mesh = CGP::geodesic_sphere(8);
  const Eigen::VectorXd rho = mesh.positions().row(0).array().sin().matrix().transpose();
  const auto result =
      CGP::Spin_transformation(mesh).transform(CGP::Curvature_potential::on_vertices(rho));
  return result.report ? 0 : 1;
}
"""


def executed(folder):
    """The library's headers with at least one executed line, by folder of the library."""
    (folder / "one.cpp").write_text(PROGRAM)
    header_only.write(folder)
    flags = ["-std=c++17", "-O0", "--coverage", "-I.", "-isystem", "/usr/include/eigen3", "-pthread"]
    subprocess.run(["g++", *flags, "one.cpp", "-o", "one"], cwd=folder, check=True)
    subprocess.run(["./one"], cwd=folder, check=True)
    notes = next(folder.glob("*.gcno"))
    subprocess.run(["gcov", "--json-format", notes.name], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)
    headers = set()
    for path in folder.glob("*.gcov.json.gz"):
        for file in json.loads(gzip.decompress(path.read_bytes()))["files"]:
            name = pathlib.Path(file["file"])
            path = re.search(rf"(?:{sources.LIBRARY}|{sources.SOLVERS})/.*", name.as_posix())
            if path and any(line["count"] for line in file["lines"]):
                headers.add(path[0].partition("/")[2])
    return headers


def rows(folder):
    """(folder of the library, modules with executed lines, headers that have such lines themselves),
    and the same of all; X.h and X.cpp, which is X_impl.h here, are one module."""
    headers = executed(folder)
    modules = {re.sub(r"_impl\.h$", ".h", header) for header in headers}
    of_folder = [collections.Counter(name.rpartition("/")[0] for name in names)
                 for names in (modules, modules & headers)]
    for name, count in sorted(of_folder[0].items()):
        yield [f"`{name}/`", count, of_folder[1][name]]
    yield ["all", len(modules), len(modules & headers)]
