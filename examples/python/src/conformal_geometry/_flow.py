# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The conformal Willmore flow."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Optional

import numpy as np

from . import _kernels
from ._arrays import faces, points, real_or_none
from ._boundary import Boundary_condition
from ._report import Result, build
from ._reports import Flow_report, Flow_step_report, flow_report
from ._types import Faces, Point_array, Points, Vertex_values


@dataclass(frozen=True, eq=False)
class Flow_result(Result):
    """The last surface of a flow, which is within the limits of distortion in every case."""
    positions: Point_array  #: n x 3
    report: Flow_report


Step_callback = Callable[[Flow_step_report, np.ndarray], Optional[bool]]


def willmore_flow(V: Points, F: Faces, *, max_steps: int = 100, time_step: float = 1.,
                  min_time_step: float = 1e-2, energy_tolerance: float = 1e-4,
                  filter_weight: float = 0., filter_order: int = 1, balance: str = "none",
                  balancing: str = "inversion", target_areas: Optional[Vertex_values] = None,
                  boundary: Optional[Boundary_condition] = None,
                  exact_conformal_class: bool = True, fairing: bool = True,
                  max_scale: Optional[float] = None, reduced_volume: Optional[float] = None,
                  exactness: Optional[str] = "adjoint",
                  max_period_defect: Optional[float] = None,
                  mollification: Optional[float] = None, random_seed: int = 0,
                  callback: Optional[Step_callback] = None) -> Flow_result:
    """Makes a surface as smooth as its conformal class allows, in a few large steps that keep
    angles, and so textures and the shapes of triangles [CGP 6.4].

    Each step smooths the surface within its conformal class, and transforms it by rho = -tau H.
    Spheres become round, tori become tori of Clifford type; handles stay closed. The energy, the
    integral of H^2, falls in every step; area and centroid are kept. Where long limbs would have to
    shrink to nothing, the flow stops with the last surface within the limits, and says so.

    Parameters
    ----------
    V : (n, 3) array, F : (m, 3) array of integers
        a connected, oriented manifold
    max_steps : int
    time_step, min_time_step : float
        the largest tau, stable below 2 on every mesh, and where backtracking ends
    energy_tolerance : float
        the flow ends where the energy changes by less than this share of it in a time of 1
    filter_weight, filter_order : float, int
        a weight > 0 smooths details and keeps the overall shape; the order sharpens the cut-off
    balance : "none", "initial" or "canonical"
        the vertex areas towards which the surface is balanced among its Moebius transforms
    balancing : "inversion" or "potential"
        how balance is kept
    target_areas : (n,) array, optional
        areas for the balance, of which only ratios matter
    boundary : Boundary_condition, optional
        free, or directions
    exact_conformal_class, fairing : bool
        whether closed surfaces stay on their exact discrete conformal class, and steps begin with
        smoothing within it; without both, it is the flow of the thesis
    max_scale : float > 1, optional
        the largest factor by which lengths may differ from those of V, on 98 % of the area: limbs,
        and what is behind a thin neck, become no smaller
    reduced_volume : float, optional
        the volume, by that of the round sphere of the same area, that a closed surface keeps or, by
        a twentieth in a step, reaches: the shapes of least energy are those of vesicles
    exactness, max_period_defect, mollification, random_seed
        as in ``spin_transform()``
    callback : function of (Flow_step_report, positions), optional
        called after every step; returns False to stop there. What it raises ends the flow, as
        Ctrl-C does with or without a callback.

    Returns
    -------
    Flow_result
        true if the flow has converged or made all steps, and is conformal from start to end
    """
    name = "willmore_flow"
    options = dict(max_steps=max_steps, time_step=time_step, min_time_step=min_time_step,
                   energy_tolerance=energy_tolerance, filter_weight=filter_weight,
                   filter_order=filter_order, balance=balance, balancing=balancing,
                   target_areas=real_or_none(target_areas, name, "areas"), boundary=boundary,
                   exact_conformal_class=exact_conformal_class, fairing=fairing,
                   max_scale=max_scale, reduced_volume=reduced_volume,
                   exactness=exactness, max_period_defect=max_period_defect,
                   mollification=mollification, random_seed=random_seed)
    on_step = None if callback is None else (
        lambda step, positions: callback(build(Flow_step_report, step), positions))
    positions, report = _kernels.willmore_flow(points(V, name), faces(F, name), options, on_step)
    return Flow_result(positions, flow_report(report))
