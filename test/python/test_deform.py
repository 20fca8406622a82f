# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Control points: they are met, the surface is that of the rho found, and dragging changes nothing."""

import numpy as np
import pytest

import conformal_geometry as cg
from meshes import icosphere, patch, torus


def held(V, count=8):
    return {v: V[v] for v in range(0, len(V), len(V) // (count - 1))}


def one_moved(V, move):
    targets = held(V)
    moved = list(targets)[3]
    return {**targets, moved: V[moved] + move}


def missed(result, targets):
    return max(np.linalg.norm(result.positions[v] - to) for v, to in targets.items())


@pytest.mark.parametrize("mesh", [icosphere(3), torus(24, 12), patch(10, .1)])
def test_targets_are_met(mesh):
    V, F = mesh
    targets = one_moved(V, np.multiply(.1, [.6, .5, .62]))
    result = cg.deform(V, F, targets)
    assert result, result.report.fault
    assert result.report.reached == 1
    assert missed(result, targets) < 1e-8 * np.linalg.norm(np.ptp(V, axis=0))
    assert missed(result, targets) == pytest.approx(result.report.position_error.max)
    assert result.report.conformality.quasi_conformal.mean < 1.05


def test_the_surface_is_near_that_of_its_rho():
    V, F = icosphere(2)
    result = cg.deform(V, F, one_moved(V, [.1, .1, 0]))
    assert result.report.is_relaxed  # its spins are not an eigenvector
    again = cg.spin_transform(V, F, result.rho, on="vertices", max_scale=None)
    assert cg.quasi_conformal_errors(result.positions, F, again.positions).mean() < 1.05
    lengths = [np.linalg.norm(p[F[:, 0]] - p[F[:, 1]], axis=1)
               for p in (result.positions, again.positions)]
    ratio = lengths[0] / lengths[1]
    assert ratio.std() < .05 * ratio.mean()



def test_targets_that_stay_need_no_curvature():
    V, F = icosphere(2, .05)
    result = cg.deform(V, F, held(V))
    assert np.abs(result.positions - V).max() < 1e-7
    assert np.abs(result.rho).max() < 1e-6


def test_dragging_step_by_step_leads_where_one_move_does():
    V, F = torus(24, 12)
    drag = cg.Conformal_deformation(V, F)
    move = np.array([.2, .15, .2])
    first = drag.deform(one_moved(V, .2 * move)).report
    for share in (.4, .6, .8, 1):
        last = drag.deform(one_moved(V, share * move))
        assert last and last.report.factorizations <= 2 * first.factorizations
    whole = cg.deform(V, F, one_moved(V, move))
    assert np.abs(last.positions - whole.positions).max() < .02
    masses = cg.vertex_areas(V, F)
    assert masses @ last.rho ** 2 == pytest.approx(masses @ whole.rho ** 2, rel=.03)
    assert missed(last, one_moved(V, move)) < 1e-7


def test_a_weight_makes_the_targets_soft():
    V, F = icosphere(2)
    targets = one_moved(V, [.2, .1, 0])
    errors = [missed(cg.deform(V, F, targets, position_weight=w), targets) for w in (10, 100, 1000)]
    assert errors[0] > 2 * errors[1] > 4 * errors[2]


def test_what_is_beyond_reach_is_false_with_its_share():
    V, F = icosphere(2)
    result = cg.deform(V, F, one_moved(V, [0, 6, 0]))
    assert not result and result.report.reached < 1
    assert result.report.conformality.flipped_faces == 0


def test_refusals_name_the_target():
    V, F = icosphere(1)
    with pytest.raises(cg.Precondition_error, match="no (control )?point|no targets"):
        cg.deform(V, F, {})
    with pytest.raises(cg.Precondition_error, match="99"):
        cg.deform(V, F, {0: V[0], 99: V[0]})
    with pytest.raises(cg.Precondition_error, match="not finite"):
        cg.deform(V, F, {0: (np.nan, 0, 0)})
    with pytest.raises(cg.Precondition_error, match="at one place"):
        cg.deform(V, F, {0: V[0], 1: V[0]})


def test_parts_of_a_region_without_targets_stay():
    V, F = icosphere(3)
    region = np.clip((abs(V[:, 2]) - .5) / .3, 0, 1)
    drag = cg.Conformal_deformation(V, F, vertex_region=region)
    for top in V[:, 2].argmax(), V[:, 2].argmin():  # of either part
        result = drag.deform({top: V[top] + [.1, .05, .05]})
        assert result and result.report.reached == 1
        stays = V[:, 2] * V[top, 2] < .25
        assert np.array_equal(result.positions[stays], V[stays])


def test_outside_of_a_region_nothing_moves():
    V, F = icosphere(3)
    V = V * [1, 1.2, 1.5] + .05 * np.sin(3 * V[:, [1, 2, 0]])
    region = np.clip((V[:, 2] + .5) / .8, 0, 1)
    top = int(np.argmax(V[:, 2]))
    result = cg.deform(V, F, {top: V[top] + [.15, .05, .05]}, vertex_region=region)
    assert result, result.report.fault
    assert np.array_equal(result.positions[region == 0], V[region == 0])
    assert np.linalg.norm(result.positions[top] - V[top] - [.15, .05, .05]) < 1e-7
    assert 1 < result.report.collar.quasi_conformal.mean < 1.2
    assert cg.deform(V, F, {top: V[top]}).report.collar is None
