# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Laws of spin transformations, by way of arrays."""

import signal
import threading
import time

import numpy as np
import pytest

import conformal_geometry as cg
from conformal_geometry import _kernels
from meshes import icosphere, patch, torus

V, F = icosphere(3, .02)
RHO = np.sin(3 * V[:, 1]) + V[:, 0] ** 2


def same_bits(a, b):
    return np.array_equal(a.positions, b.positions) and np.array_equal(a.spins, b.spins)


def test_is_conformal_and_keeps_area_and_centroid():
    result = cg.spin_transform(V, F, RHO)
    assert result and result.report.fault is None
    errors = cg.quasi_conformal_errors(V, F, result.positions)
    areas = cg.face_areas(V, F)
    assert errors @ areas / areas.sum() == pytest.approx(
        result.report.conformality.quasi_conformal.mean, rel=1e-9)
    assert errors.max() < 1.3
    new_areas = cg.face_areas(result.positions, F)
    assert new_areas.sum() == pytest.approx(areas.sum(), rel=1e-9)

    def centroid(points, weights):
        return weights @ points[F].mean(axis=1) / weights.sum()

    assert centroid(result.positions, new_areas) == pytest.approx(centroid(V, areas), abs=1e-9)


def test_changes_the_curvature_as_asked():
    V, F = icosphere(4)
    rho = .5 * V[:, 1] * V[:, 0]
    result = cg.spin_transform(V, F, rho, max_scale=None)
    scale = (result.spins ** 2).sum(axis=1)
    realised = cg.mean_curvature(result.positions, F) * scale
    wanted = cg.mean_curvature(V, F) + rho + result.report.eigenvalue
    assert np.sqrt(np.mean((realised - wanted) ** 2)) < .02 * np.std(rho)


def test_constants_have_no_effect():
    for bound in (None, cg.default_max_scale):
        plain, shifted = (cg.spin_transform(V, F, RHO + c, max_scale=bound) for c in (0, 1.5))
        assert np.abs(plain.positions - shifted.positions).max() < 1e-6
        assert shifted.report.eigenvalue == pytest.approx(plain.report.eigenvalue - 1.5, abs=1e-6)


def test_commutes_with_similarities():
    turn = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))[0]
    turn *= np.sign(np.linalg.det(turn))
    moved = cg.spin_transform(5 * V @ turn.T + [1, 2, 3], F, RHO / 5)
    expected = 5 * cg.spin_transform(V, F, RHO).positions @ turn.T + [1, 2, 3]
    assert np.abs(moved.positions - expected).max() < 1e-6


def test_does_not_see_the_layout_of_the_arrays():
    first = cg.spin_transform(V, F, RHO)
    for points in (np.asfortranarray(V), V.tolist(), np.repeat(V, 2, axis=0)[::2]):
        assert same_bits(first, cg.spin_transform(points, F, RHO))
    for kind in (np.int16, np.int32, np.uint32, np.uint64, ">i4"):
        assert same_bits(first, cg.spin_transform(V, np.asfortranarray(F.astype(kind)), RHO))
    assert same_bits(first, cg.spin_transform(V, F, list(RHO), on="vertices"))


def test_leaves_its_input_alone():
    before = V.copy(), F.copy(), RHO.copy()
    cg.spin_transform(V, F, RHO, max_scale=1.2)
    for array, copy in zip((V, F, RHO), before):
        assert np.array_equal(array, copy)


def test_takes_rho_on_faces():
    on_faces = RHO[F].mean(axis=1)
    result = cg.spin_transform(V, F, on_faces, max_scale=None)
    assert result
    generalized = cg.spin_transform(V, F, on_faces, max_scale=None,
                                    dirac=cg.Dirac_options(eigenproblem="generalized"))
    assert np.abs(result.positions - generalized.positions).max() < .05


def test_bounds_scales():
    V, F = icosphere(2, .05)
    rho = 4 * np.sin(3 * V[:, 1])
    free, bound = (cg.spin_transform(V, F, rho, max_scale=b) for b in (None, 1.5))
    assert bound and bound.report.scales.bound == 1.5
    assert 1 / 1.5 <= bound.report.scales.low and bound.report.scales.high <= 1.5
    assert bound.report.scales.kept_norm < 1
    assert np.ptp(np.log((free.spins ** 2).sum(axis=1))) > np.ptp(
        np.log((bound.spins ** 2).sum(axis=1)))
    held = cg.spin_transform(V, F, rho, max_scale=1.5, vertex_scale_weight=1. * (V[:, 0] > 0))
    assert not same_bits(held, bound)


def test_the_bound_is_two_unless_told_otherwise():
    V, F = icosphere(3, .05)
    rho, factors = 4 * np.sin(3 * V[:, 1]), np.exp(.5 * V[:, 0])
    usual = cg.spin_transform(V, F, rho)
    assert cg.default_max_scale == 2 and usual.report.scales.bound == 2
    assert same_bits(usual, cg.spin_transform(V, F, rho, max_scale=2))
    assert same_bits(usual, cg.Spin_transformation(V, F).transform(rho))
    wanted = cg.spin_transform(V, F, rho, vertex_scale=factors)
    assert wanted.report.scales.bound == 1.25
    assert same_bits(wanted, cg.spin_transform(V, F, rho, max_scale=1.25, vertex_scale=factors))
    eigenvector = cg.spin_transform(V, F, .1 * rho, max_scale=None).report
    assert eigenvector.scales.bound == 0 and not eigenvector.is_relaxed
    targets = {0: V[0], 9: V[9], 30: V[30], 50: 1.1 * V[50]}
    moved = cg.deform(V, F, targets)
    assert same_bits(moved, cg.deform(V, F, targets, max_scale=2.))
    assert moved.report.scales.bound == 2
    assert cg.deform(V, F, targets, max_scale=None).report.scales.bound == 0


def test_keeps_handles_closed():
    V, F = torus(24, 12)
    rho = .3 * np.cos(np.arctan2(V[:, 1], V[:, 0])) + .2 * V[:, 2]
    closed, sheared = (cg.spin_transform(V, F, rho, exactness=e, max_scale=None)
                       for e in ("adjoint", None))
    assert closed and closed.report.period_defect < .02
    assert closed.report.closure_residual < sheared.report.closure_residual


def test_many_edits_are_those_of_single_calls():
    edits = cg.Spin_transformation(V, F)
    for rho in (RHO, -RHO):
        assert same_bits(edits.transform(rho), cg.spin_transform(V, F, rho))
    assert np.array_equal(edits.positions, V)
    edits.positions = 2 * V
    assert np.array_equal(edits.positions, 2 * V)
    assert np.abs(edits.transform(RHO / 2).positions
                  - 2 * cg.spin_transform(V, F, RHO).positions).max() < 1e-6


def test_integrates_given_spins():
    spins = np.tile([2., 0, 0, 0], (len(V), 1))
    result = cg.Spin_transformation(V, F).integrate(spins)
    assert np.abs(result.positions - V).max() < 1e-12


@pytest.mark.parametrize("condition", [
    cg.Boundary_condition.free(), cg.Boundary_condition.tangents(),
    cg.Boundary_condition.binormals()])
def test_at_a_boundary(condition):
    V, F = patch(12, .1)
    result = cg.spin_transform(V, F, .4 * V[:, 0], boundary=condition)
    assert result
    assert result.report.direction_error.mean < .05


def test_moves_a_boundary_to_positions():
    V, F = patch(10)
    target = 1.2 * V
    result = cg.spin_transform(V, F, np.zeros(len(V)), on="vertices",
                               boundary=cg.Boundary_condition.positions(target))
    rim = np.abs(V[:, :2]).max(axis=1) == 1
    assert result.report.has_positions
    assert np.abs(result.positions - target)[rim].max() < 1e-9


def test_admits_flat_faces_with_mollification():
    W = np.vstack([V, V[F[0]].mean(axis=0), (V[F[1][0]] + V[F[1][1]]) / 2])
    n, (a, b, c), (d, e, f) = len(V), F[0], F[1]
    G = np.vstack([F[2:], [(a, b, n), (b, c, n), (c, a, n), (d, n + 1, f), (n + 1, e, f)]])
    G = np.vstack([G, (e, n + 1, d)])  # of area zero, to the neighbour
    with pytest.raises(cg.Precondition_error, match="face of area zero") as refused:
        cg.spin_transform(W, G, np.zeros(len(W)))
    assert refused.value.element == ("face", len(G) - 1)
    assert cg.spin_transform(W, G, .3 * W[:, 1], mollification=1e-6)


def test_a_minimal_surface_has_no_mean_curvature():
    V, F = patch(16)
    V[:, 2] /= 4
    result = cg.minimal_surface(V, F)
    inside = np.abs(V[:, :2]).max(axis=1) < .8
    before, after = (np.abs(cg.mean_curvature(p, F))[inside].mean() for p in (V, result.positions))
    assert result and after < .1 * before


def test_a_callback_watches_and_cancels():
    seen = []
    assert cg.spin_transform(V, F, RHO, max_scale=None, callback=seen.append)
    assert seen and seen[0].iteration >= 0 and seen[-1].estimate < 1e-4
    result = cg.spin_transform(V, F, RHO, callback=lambda progress: False)
    assert not result and result.report.fault == "cancelled" and len(result.positions) == 0


def test_what_a_callback_raises_propagates():
    def interrupt(progress):
        raise KeyboardInterrupt

    edits = cg.Spin_transformation(V, F)
    with pytest.raises(KeyboardInterrupt):
        edits.transform(RHO, callback=interrupt)
    assert same_bits(edits.transform(RHO), cg.spin_transform(V, F, RHO))


def test_an_object_computes_for_one_at_a_time():
    edits, refused = cg.Spin_transformation(V, F), []

    def again(progress):
        with pytest.raises(cg.Precondition_error, match="computing already") as error:
            edits.transform(RHO)
        refused.append(error)

    assert edits.transform(RHO, callback=again) and refused


def test_the_interpreter_goes_on_meanwhile():
    V, F = icosphere(4)
    computing = threading.Thread(target=cg.spin_transform, args=(V, F, np.sin(4 * V[:, 1])))
    computing.start()
    turns = 0
    while computing.is_alive():
        time.sleep(1e-3)
        turns += 1
    assert turns > 10  # with its lock held, there are a few, between two calls of the kernels


def test_signals_arrive_while_it_computes():
    calls, results = [], []

    def handle(number, frame):
        calls.append(number)
        if len(calls) == 4:  # signals that wait for the end arrive as one
            raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, handle)
    signal.setitimer(signal.ITIMER_REAL, .02, .02)
    try:
        with pytest.raises(KeyboardInterrupt):
            results.append(_kernels.willmore_flow(*stretched(), dict(energy_tolerance=0.), None))
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert not results


def stretched():
    V, F = icosphere(4, .02)
    return V * [1, 1, 2], F


def test_other_threads_compute_meanwhile():
    results = {}
    threads = [threading.Thread(target=lambda k=k: results.update(
        {k: cg.spin_transform(V, F, (1 + k % 2) * RHO)})) for k in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert same_bits(results[0], results[2]) and same_bits(results[1], results[3])
