# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The derivative, the matrices, the flow, maps, forms, spectra: identities, not stored results."""

import numpy as np
import pytest
from scipy.sparse import diags

import conformal_geometry as cg
from meshes import icosphere, patch, torus

V, F = icosphere(2, .05)
RHO = np.sin(3 * V[:, 1]) + .5 * V[:, 0]


@pytest.mark.parametrize("mesh", [(V, F, RHO), (*torus(16, 8), None), (*patch(7, .1), None)])
def test_the_derivative_is_the_limit_of_differences(mesh):
    V, F, rho = mesh
    rho = .3 * np.sin(2 * V[:, 0]) + .2 * V[:, 1] if rho is None else rho
    direction = np.random.default_rng(2).normal(size=len(V))
    derivative = cg.Spin_derivative(V, F, rho, on="vertices")
    edits = cg.Spin_transformation(V, F, exactness=None, max_scale=None)
    step = 1e-4
    after, before = (edits.transform(rho + s * direction, on="vertices", tolerance=1e-13)
                     for s in (step, -step))
    difference = (after.positions - before.positions) / (2 * step)
    velocity = (derivative.positions @ direction).reshape(-1, 3)
    assert np.linalg.norm(velocity - difference) < 1e-5 * np.linalg.norm(difference)
    masses = cg.vertex_areas(V, F)
    u = [np.log((r.spins ** 2).sum(axis=1)) for r in (after, before)]
    change = (u[0] - u[1]) / (2 * step)
    change -= masses @ change / masses.sum()
    assert derivative.log_scales @ direction == pytest.approx(
        change, abs=1e-5 * np.abs(change).max())
    gamma = (after.report.eigenvalue - before.report.eigenvalue) / (2 * step)
    if derivative.eigenvalue_change(direction) != 0:
        assert derivative.eigenvalue_change(direction) == pytest.approx(gamma, abs=1e-6)


def test_the_derivative_has_its_transpose_and_takes_blocks():
    derivative = cg.Spin_transformation(7 * V, F).derivative(RHO / 7)
    random = np.random.default_rng(5)
    x = random.normal(size=(len(V), 3))
    for A in (derivative.spins, derivative.log_scales, derivative.positions):
        y = random.normal(size=A.shape[0])
        one = A @ x[:, 0]
        assert y @ one == pytest.approx(x[:, 0] @ (A.T @ y), rel=1e-8)
        assert (A @ x)[:, 0] == pytest.approx(one, rel=1e-6, abs=1e-8)
    assert derivative.eigenvalue_change(np.ones(len(V))) == pytest.approx(-1, abs=1e-9)


def test_the_dirac_operator():
    for V, F in ((globals()["V"], globals()["F"]), patch(6, .1)):
        D = cg.dirac_operator(V, F)
        assert D.shape == (4 * len(F), 4 * len(V))
        constants = np.kron(np.ones((len(V), 1)), np.eye(4))
        assert np.abs(D @ constants).max() < 1e-12
        normals = np.cross(V[F[:, 1]] - V[F[:, 0]], V[F[:, 2]] - V[F[:, 0]])
        normals /= np.linalg.norm(normals, axis=1, keepdims=True)
        f = np.column_stack([np.zeros(len(V)), V]).ravel()
        assert (D @ f).reshape(-1, 4)[:, 1:] == pytest.approx(-2 * normals, abs=1e-10)
        assert np.abs((D @ f).reshape(-1, 4)[:, 0]).max() < 1e-10


def test_the_energy_is_that_of_the_operator():
    D, X = cg.dirac_operator(V, F), cg.dirac_energy(V, F)
    masses = diags(np.repeat(cg.face_areas(V, F), 4))
    assert np.abs((D.T @ masses @ D - X).toarray()).max() < 1e-11
    result = cg.spin_transform(V, F, RHO, max_scale=None, tolerance=1e-11)
    with_rho = cg.dirac_energy(V, F, RHO + result.report.eigenvalue).toarray()
    assert np.abs(with_rho - with_rho.T).max() < 1e-13
    assert np.linalg.eigvalsh(with_rho).min() > -1e-12
    spins, M = result.spins.ravel(), np.repeat(cg.vertex_areas(V, F), 4)
    quotient = spins @ with_rho @ spins / (spins @ (M * spins))
    assert np.linalg.norm((with_rho @ spins - quotient * M * spins) / np.sqrt(M)) < 1e-7


def test_the_laplacian():
    L = cg.cotan_laplacian(V, F)
    assert abs(L - L.T).max() < 1e-15
    assert np.abs(L @ np.ones(len(V))).max() < 1e-12
    real_part = cg.dirac_energy(V, F).tocsr()[::4, ::4]
    assert abs(L - real_part).max() < 1e-12
    assert cg.vertex_areas(V, F).sum() == pytest.approx(cg.face_areas(V, F).sum(), rel=1e-13)


def test_the_flow_makes_spheres_round():
    start = cg.spin_transform(*icosphere(3), 2 * icosphere(3)[0][:, 1] ** 2).positions
    F = icosphere(3)[1]
    steps = []
    result = cg.willmore_flow(start, F, callback=lambda step, points: steps.append((step, points)))
    assert result and result.report.converged
    assert result.report.energy < 1.01 * 4 * np.pi < result.report.initial_energy
    energies = [step.energy for step, _ in steps]
    assert all(a >= b for a, b in zip(energies, energies[1:]))
    assert tuple(step for step, _ in steps) == result.report.steps
    assert steps[0][1].shape == start.shape
    again = cg.willmore_flow(np.asfortranarray(start), F.astype(np.uint16))
    assert np.array_equal(again.positions, result.positions)


def test_the_flow_keeps_a_volume():
    start = V * [1, 1, 1.8]
    report = cg.willmore_flow(start, F, reduced_volume=.85, max_steps=40).report
    assert report and report.missing_volume == pytest.approx(0, abs=1e-9)
    assert report.enclosure.reduced_volume == pytest.approx(.85, abs=1e-9)
    volume = np.einsum("ij,ij->", start[F[:, 0]], np.cross(start[F[:, 1]], start[F[:, 2]])) / 6
    assert report.initial_enclosure.volume == pytest.approx(volume, rel=1e-12)
    less = cg.willmore_flow(start, F, reduced_volume=.5, max_steps=1).report
    assert not less and less.fault.startswith("the prescribed volume is not reached; all steps")


def test_the_flow_stops_where_a_callback_says():
    start = V * [1, 1, 1.5]
    result = cg.willmore_flow(start, F, callback=lambda step, points: False)
    assert len(result.report.steps) == 1 and not result
    assert result.report.fault.startswith("cancelled")

    def interrupt(step, points):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        cg.willmore_flow(start, F, callback=interrupt)


def sums_of_opposite_angles(V, F):
    """edge -> the sum of the angles opposite to it"""
    sums = {}
    for k in range(3):
        for a, b, c in np.roll(F, k, axis=1):
            p, q = V[b] - V[a], V[c] - V[a]
            angle = np.arctan2(np.linalg.norm(np.cross(p, q)), p @ q)
            sums[min(b, c), max(b, c)] = sums.get((min(b, c), max(b, c)), 0) + angle
    return sums


def test_flipped_faces_are_delaunay_and_flow_as_they_are_judged():
    thin = V * [4, 1, 1]
    assert max(sums_of_opposite_angles(thin, F).values()) > np.pi + .5
    made = cg.make_delaunay(thin, F)
    assert made.flips > 50
    assert max(sums_of_opposite_angles(thin, made.faces).values()) < np.pi + 1e-9
    same = np.setdiff1d(np.arange(len(F)), made.changed)
    assert all(set(a) == set(b) for a, b in zip(F[same], made.faces[same]))
    assert all(set(F[k]) != set(made.faces[k]) for k in made.changed)
    assert cg.make_delaunay(thin, made.faces).flips == 0
    report = cg.willmore_flow(thin, made.faces, max_steps=2).report
    assert report and report.energy_of_faces == report.energy


def test_snapping_restores_length_cross_ratios():
    spun = cg.spin_transform(V, F, RHO).positions
    snapped = cg.snap_to_conformal_class(spun, V, F)
    assert snapped and snapped.report.length_cross_ratio.max <= 1e-10
    assert snapped.report.initial_length_cross_ratio.max > 1e-4

    def sphere_inversion(points):
        arms = points - [0, 0, 3]
        return arms / (arms ** 2).sum(axis=1, keepdims=True)

    moebius = cg.snap_to_conformal_class(sphere_inversion(V), V, F)
    assert moebius and moebius.report.displacement < 1e-9  # Moebius maps keep the class


def test_flattening_is_conformal():
    V, F = patch(15)
    result = cg.flatten(V, F)
    assert result and result.uv.shape == (len(V), 2)
    plane = np.column_stack([result.uv, np.zeros(len(V))])
    assert cg.face_areas(plane, F).sum() == pytest.approx(cg.face_areas(V, F).sum(), rel=1e-9)
    assert result.report.conformality.flipped_faces == 0
    assert cg.quasi_conformal_errors(V, F, plane).mean() < 1.05


def test_harmonic_forms_are_closed_and_coclosed():
    V, F = torus(12, 9)
    V = 7 * V
    basis = cg.harmonic_basis(V, F)
    assert len(basis) == 2 and basis.fields.shape == (2, len(F), 3)
    number = {tuple(edge): k for k, edge in enumerate(basis.edges)}
    for face in F:
        around = sum(np.sign(b - a) * basis.one_forms[number[min(a, b), max(a, b)]]
                     for a, b in zip(face, np.roll(face, -1)))
        assert np.abs(around).max() < 1e-12
    ends = V[F[:, 1]] - V[F[:, 0]]  # along the first edge of each face, the field is the form
    forms = np.array([np.sign(b - a) * basis.one_forms[number[min(a, b), max(a, b)]]
                      for a, b, _ in F])
    assert np.einsum("kfi,fi->fk", basis.fields, ends) == pytest.approx(forms, abs=1e-11)
    L = cg.cotan_laplacian(V, F).tocsr()
    weights = -np.array([L[i, j] for i, j in basis.edges])
    for form in basis.one_forms.T:
        out = np.zeros(len(V))
        np.add.at(out, basis.edges[:, 0], weights * form)
        np.add.at(out, basis.edges[:, 1], -weights * form)
        assert np.abs(out).max() < 1e-10
    assert len(cg.harmonic_basis(*icosphere(1))) == 0


def test_the_spectrum_of_a_sphere():
    V, F = icosphere(3)
    found = cg.dirac_spectrum(V, F, 9)
    assert found and np.abs(found.eigenvalues - np.rint(found.eigenvalues)).max() < .05
    assert sorted(np.rint(found.eigenvalues)) == [-3, -3, -2, 0, 1, 1, 2, 2, 2]
    assert found.vectors.shape == (9, len(V), 4)
    shifted = cg.dirac_spectrum(V, F, 2, shift=1., rho=np.full(len(V), .25))
    assert shifted.eigenvalues == pytest.approx([.75, .75], abs=.02)


def test_the_nearest_to_a_conformal_deformation_is_itself():
    spun = cg.spin_transform(V, F, .3 * RHO).positions
    result = cg.nearest(V, spun, F)
    assert result and result.distance < .01 and result.sign_conflicts == 0
    sheared = cg.nearest(V, V * [1, 1, 1.3], F, keep_curvature=True)
    assert sheared and sheared.report.conformality.quasi_conformal.mean < 1.1
    blended = cg.nearest(V, V * [1, 1, 1.3], F, blend=1., keep_curvature=True)
    assert blended.distance < sheared.distance
    free = cg.nearest(V, V * [1, 1, 1.3], F)
    assert free.distance < sheared.distance and free.report.scales.bound == 0
    assert cg.nearest(V, V * [1, 1, 1.3], F, max_scale=1.1).report.scales.high <= 1.1


def test_blending_reaches_both_ends():
    spun = cg.spin_transform(V, F, .5 * RHO, max_scale=None).positions
    start, end = (cg.blend(V, spun, F, t).positions for t in (0, 1))
    assert np.abs(start - V).max() < 1e-6

    def shape(points):
        return np.linalg.norm(points[F] - points[np.roll(F, 1, axis=1)], axis=2)

    assert np.abs(shape(end) - shape(spun)).max() < 1e-3 * shape(spun).max()
    onto = cg.blend(V, spun, F, 0, onto=spun).positions
    assert np.abs(onto - spun).max() < 1e-6
    W, G = patch(9)
    assert cg.blend(W, cg.spin_transform(W, G, .2 * W[:, 0]).positions, G, .5)
