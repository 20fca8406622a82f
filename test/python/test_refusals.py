# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Unsuitable input: a typed error that names the first offending element."""

import numpy as np
import pytest

import conformal_geometry as cg
from meshes import icosphere, patch

V, F = icosphere(2)
RHO = np.sin(3 * V[:, 1])
FUNCTIONS = [
    lambda V, F: cg.spin_transform(V, F, np.zeros(len(V)), on="vertices"),
    lambda V, F: cg.Spin_transformation(V, F),
    lambda V, F: cg.Spin_derivative(V, F, np.zeros(len(V)), on="vertices"),
    cg.willmore_flow, cg.flatten, cg.minimal_surface, cg.harmonic_basis, cg.make_delaunay,
    lambda V, F: cg.dirac_spectrum(V, F, 3),
    lambda V, F: cg.deform(V, F, {0: (0, 0, 1)}),
    lambda V, F: cg.nearest(V, V, F),
    lambda V, F: cg.blend(V, V, F),
    lambda V, F: cg.snap_to_conformal_class(V, V, F),
    cg.dirac_operator, cg.dirac_energy, cg.cotan_laplacian, cg.vertex_areas, cg.face_areas,
    cg.mean_curvature, lambda V, F: cg.quasi_conformal_errors(V, F, V),
]


def with_row(array, row, value):
    changed = array.copy()
    changed[row] = value
    return changed


def meshes():
    yield "index", V, with_row(F, 7, (0, 1, 162)), "1 face with an index out of range", ("face", 7)
    yield "negative", V, with_row(F, 9, (0, -1, 2)), "vertices 0, -1, 2", ("face", 9)
    yield "float", V, F * 1., "integers are needed", None
    yield "complex", V + 0j, F, "real numbers are needed", None
    yield "plane", V[:, :2], F, r"shape \(162, 2\)", None
    yield "quads", V, np.column_stack([F, F[:, 0]]), r"shape \(320, 4\)", None
    yield "empty", [], [], "no faces", None
    yield "nan", with_row(V, 5, np.nan), F, "not finite", ("vertex", 5)
    yield "repeated", V, with_row(F, 3, (1, 1, 2)), "repeated vertex", ("face", 3)
    yield "isolated", np.vstack([V, [9, 9, 9]]), F, "without a face", ("vertex", 162)
    yield "third", np.vstack([V, [0, 0, 2]]), np.vstack(
        [F, (*F[0][:2], 162)]), "more than two faces", ("edge", tuple(sorted(F[0][:2])))
    yield "turned", V, with_row(F, 0, F[0][::-1]), "oriented against each other", None


@pytest.mark.parametrize("function", FUNCTIONS)
def test_of_meshes(function):
    for name, points, faces, message, element in meshes():
        with pytest.raises(cg.Precondition_error, match=message) as refused:
            function(points, faces)
        if element:
            assert refused.value.element == element, name


def test_errors_are_those_of_python_too():
    with pytest.raises(ValueError) as refused:
        cg.spin_transform(V, F, RHO[:3])
    error = refused.value
    assert error.function == "spin_transform" and error.element is None
    assert str(error) == f"spin_transform: {error.message}"
    assert "3 values, one per vertex is needed: 162" in error.message
    assert issubclass(cg.Solver_error, RuntimeError) and issubclass(cg.Solver_error, cg.Error)


@pytest.mark.parametrize("options, message", [
    (dict(max_scale=1), "a number above 1"),
    (dict(max_scale=2, vertex_scale=np.ones(3)), "one per vertex is needed: 162"),
    (dict(max_scale=2, vertex_scale_weight=-np.ones(162)), "vertex 0 has the value -1"),
    (dict(max_scale=2, vertex_scale=[]), "vertex_scale is empty"),
    (dict(max_scale=None, vertex_scale=np.ones(162)), "need a scale bound"),
    (dict(exactness="exact"), "'adjoint', 'thesis'"),
    (dict(dirac=cg.Dirac_options(branch="other")), "'nearest', 'smallest', 'zero'"),
    (dict(on="edges"), "'vertices' or 'faces'"),
    (dict(on="faces"), "one per face is needed: 320"),
    (dict(mollification=2.), "ollification"),
    (dict(boundary=cg.Boundary_condition.tangents()), "the surface is closed"),
])
def test_of_options(options, message):
    with pytest.raises(cg.Precondition_error, match=message):
        cg.spin_transform(V, F, RHO, **options)


def test_of_types():
    for options in (dict(max_scale="two"), dict(max_iterations=1.5), dict(tolerance=[1])):
        with pytest.raises(TypeError, match=next(iter(options))):
            cg.spin_transform(V, F, RHO, **options)
    with pytest.raises(TypeError):
        cg.spin_transform(V, F, RHO, maximum_scale=2)
    with pytest.raises(TypeError, match="no limit 'Q'"):
        cg.spin_transform(V, F, RHO, limits=dict(Q=2))
    with pytest.raises(TypeError):
        cg.dirac_spectrum(V, F, 1.5)


def test_of_rho():
    with pytest.raises(cg.Precondition_error, match="not finite") as refused:
        cg.spin_transform(V, F, with_row(RHO, 4, np.inf))
    assert refused.value.element == ("vertex", 4)
    tetrahedron = np.array([(0, 2, 1), (0, 3, 2), (0, 1, 3), (1, 2, 3)])  # as many of both
    with pytest.raises(cg.Precondition_error, match="say on="):
        cg.spin_transform(np.vstack([np.zeros(3), np.eye(3)]), tetrahedron, np.zeros(4))


def test_of_boundary_data():
    W, G = patch(6)
    for targets, message in ((np.ones((4, 3)), "one per vertex is needed: 36"),
                             (np.ones((36, 2)), r"shape \(36, 2\)"),
                             (np.zeros((36, 3)), "zero or not finite")):
        with pytest.raises(cg.Precondition_error, match=message):
            cg.spin_transform(W, G, 0 * W[:, 0], on="vertices",
                              boundary=cg.Boundary_condition.tangents(targets))
    with pytest.raises(cg.Precondition_error, match="elliptic"):
        cg.spin_transform(W, G, 0 * W[:, 0], on="vertices",
                          boundary=cg.Boundary_condition.directions((0, 1, 0)))
    with pytest.raises(cg.Precondition_error, match="three coefficients"):
        cg.nearest(W, W, G, direction=(1, 0))


def test_of_targets_and_spins():
    with pytest.raises(cg.Precondition_error, match="3 targets, one per vertex is needed: 162"):
        cg.nearest(V, V[:3], F)
    with pytest.raises(cg.Precondition_error, match=r"spins of the shape \(162, 3\)"):
        cg.Spin_transformation(V, F).integrate(V)
    with pytest.raises(cg.Precondition_error, match="t is not finite"):
        cg.blend(V, V, F, np.nan)
    with pytest.raises(cg.Precondition_error):
        cg.dirac_spectrum(V, F, 0)
