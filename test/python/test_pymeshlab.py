# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The script for PyMeshLab, with as much of PyMeshLab as it asks for: the stand-in below has the
names, parameters and refusals of PyMeshLab 2025.7, as its documentation states them."""

import importlib.util
import math
import pathlib
import sys
import types

import numpy as np
import pytest

import conformal_geometry as cg
from meshes import icosphere

SCRIPT = pathlib.Path(__file__).parents[2] / "examples/python/pymeshlab_conformal_geometry.py"


class Mesh:
    def __init__(self, V, F, scalars=None):
        self.V, self.F, self.scalars, self.attributes = V.copy(), F, scalars, {}
        self.is_compact = False

    def compact(self):
        self.is_compact = True

    def vertex_matrix(self):
        assert self.is_compact
        return self.V.copy()

    def face_matrix(self):
        return self.F.copy()

    def has_vertex_scalar(self):
        return self.scalars is not None

    def vertex_scalar_array(self):
        return self.scalars.copy()

    def add_vertex_custom_point_attribute(self, attribute_values, attribute_name):
        assert attribute_name not in self.attributes and len(attribute_values) == len(self.V)
        self.attributes[attribute_name] = attribute_values

    def variables(self, vertex):
        (x, y, z), box = self.V[vertex], np.ptp(self.V, axis=0)
        named = {f"{name}_{axis}": values[vertex][k] for name, values in self.attributes.items()
                 for k, axis in enumerate("xyz")}
        return {"x": x, "y": y, "z": z, "bbdiag": np.linalg.norm(box), "sin": math.sin, **named}


class MeshSet:
    files = {}

    def load_new_mesh(self, file_name):
        self.mesh = self.files[file_name]

    def save_current_mesh(self, file_name):
        self.files[file_name] = self.mesh

    def current_mesh(self):
        return self.mesh

    def meshing_remove_duplicate_vertices(self):
        assert len(np.unique(self.mesh.V, axis=0)) == len(self.mesh.V)

    def meshing_remove_unreferenced_vertices(self):
        used = self.mesh.F.max() + 1
        self.mesh.V, self.mesh.is_compact = self.mesh.V[:used], False
        if self.mesh.has_vertex_scalar():
            self.mesh.scalars = self.mesh.scalars[:used]

    def compute_scalar_by_function_per_vertex(self, *, q="vi", normalize=False, onselected=False):
        self.mesh.scalars = np.array([eval(q, self.mesh.variables(v))
                                      for v in range(len(self.mesh.V))])

    def compute_coord_by_function(self, *, x="x", y="y", z="sin(x+y)", onselected=False):
        self.mesh.V = np.array([[eval(axis, self.mesh.variables(v)) for axis in (x, y, z)]
                                for v in range(len(self.mesh.V))])


@pytest.fixture
def script(monkeypatch):
    module = types.ModuleType("pymeshlab")
    module.MeshSet = MeshSet
    monkeypatch.setitem(sys.modules, "pymeshlab", module)
    monkeypatch.setattr(MeshSet, "files", {})
    spec = importlib.util.spec_from_file_location("pymeshlab_script", SCRIPT)
    found = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(found)
    return found


def test_an_expression_is_the_change_of_curvature(script):
    V, F = icosphere(2)
    MeshSet.files["in.ply"] = Mesh(np.vstack([V, [9, 9, 9]]), F)  # the last has no face
    script.main(["in.ply", "out.ply", "--spin", "2*sin(6*y/bbdiag)"])
    radius = np.linalg.norm(np.ptp(V, axis=0)) / 2
    box = np.linalg.norm(np.ptp(np.vstack([V, [9, 9, 9]]), axis=0))
    rho = 2 * np.sin(6 * V[:, 1] / box) / radius
    expected = cg.spin_transform(V, F, rho, on="vertices", max_scale=2).positions
    assert np.abs(expected - V).max() > .02
    assert np.allclose(MeshSet.files["out.ply"].V, expected, atol=1e-9)  # two sines


def test_edits_follow_each_other(script):
    V, F = icosphere(2, .05)
    meshes = MeshSet()
    meshes.mesh = Mesh(V, F, V[:, 2])
    assert script.spin(meshes) and script.flow(meshes, steps=2)
    assert len(meshes.mesh.attributes) == 2
    spun = meshes.mesh.attributes[min(meshes.mesh.attributes)]
    assert np.array_equal(meshes.mesh.V, cg.willmore_flow(spun, F, max_steps=2).positions)


def test_what_is_not_done_says_why(script):
    V, F = icosphere(1)
    MeshSet.files["in.ply"] = Mesh(V, F)
    with pytest.raises(RuntimeError, match="no quality"):
        script.main(["in.ply", "out.ply"])
    MeshSet.files["in.ply"] = Mesh(V, F[1:], V[:, 0])
    with pytest.raises(cg.Precondition_error):
        script.main(["in.ply", "out.ply", "--max-scale", "0.5"])
    assert "out.ply" not in MeshSet.files
