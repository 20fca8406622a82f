#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Edits meshes in PyMeshLab by their curvature, without shear: spin() and flow() work on the current
mesh of a MeshSet, as its filters do, and keep colours, texture coordinates and attributes.

usage: pymeshlab_conformal_geometry.py INPUT OUTPUT [--spin EXPRESSION | --flow STEPS]
       [--max-scale B]

EXPRESSION is the change of mean curvature in MeshLab's language, for example "3*sin(12*y/bbdiag)",
relative to a ball of the size of the mesh; without it, the quality that the vertices of INPUT have.
"""

import argparse
import itertools
import sys

import numpy as np
import pymeshlab

import conformal_geometry as cg

attribute_names = (f"conformal_{number}" for number in itertools.count())


def arrays(meshes):
    """V and F of the current mesh, after MeshLab has removed what only stands in the way."""
    meshes.meshing_remove_duplicate_vertices()
    meshes.meshing_remove_unreferenced_vertices()
    mesh = meshes.current_mesh()
    mesh.compact()
    return mesh.vertex_matrix(), mesh.face_matrix()


def move(meshes, result):
    """Takes the vertices of the current mesh to the result, or raises an error that says why not."""
    if not result:
        raise RuntimeError(result.report.fault)
    name = next(attribute_names)
    meshes.current_mesh().add_vertex_custom_point_attribute(result.positions, name)
    meshes.compute_coord_by_function(x=f"{name}_x", y=f"{name}_y", z=f"{name}_z")
    return result.report


def spin(meshes, max_scale=cg.default_max_scale):
    """Changes the mean curvature of the current mesh by the quality of its vertices; no length
    changes by more than the factor max_scale. The report."""
    if not meshes.current_mesh().has_vertex_scalar():
        raise RuntimeError("the vertices of the mesh have no quality")
    V, F = arrays(meshes)
    radius = np.linalg.norm(np.ptp(V, axis=0)) / 2
    rho = meshes.current_mesh().vertex_scalar_array() / radius
    return move(meshes, cg.spin_transform(V, F, rho, on="vertices", max_scale=max_scale))


def flow(meshes, steps=5):
    """Makes the current mesh as smooth as its conformal class allows. The report."""
    return move(meshes, cg.willmore_flow(*arrays(meshes), max_steps=steps))


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.partition("\n\n")[0])
    parser.add_argument("input")
    parser.add_argument("output")
    what = parser.add_mutually_exclusive_group()
    what.add_argument("--spin", metavar="EXPRESSION")
    what.add_argument("--flow", metavar="STEPS", type=int)
    parser.add_argument("--max-scale", metavar="B", type=float,
                        default=cg.default_max_scale)
    options = parser.parse_args(arguments)
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(options.input)
    if options.spin:
        meshes.compute_scalar_by_function_per_vertex(q=options.spin)
    report = flow(meshes, options.flow) if options.flow else spin(meshes, options.max_scale)
    quasi_conformal = report.conformality.quasi_conformal.mean
    print(f"mean quasi-conformal error {quasi_conformal:.3f}, 1 is conformal")
    meshes.save_current_mesh(options.output)


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except (cg.Error, RuntimeError) as error:
        sys.exit(str(error))
