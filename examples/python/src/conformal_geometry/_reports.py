# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The reports: all fields of those of the C++ library, by the same names."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, Dict, Optional, Tuple

from ._report import Report, build


@dataclass(frozen=True)
class Distribution:
    """Statistics of a quantity on a surface, weighted by area; 99 % lies at or below p99."""
    mean: float
    p99: float
    max: float


@dataclass(frozen=True)
class Length_cross_ratio_change:
    """Deviation of a map from discrete conformality, of logarithms; 0 for Moebius maps."""
    rms: float
    max: float


@dataclass(frozen=True)
class Area_distortion:
    """Factors of lengths, the standard deviation of their logarithms, the share of the area that
    has collapsed, and the shares of the area in half octaves from 1/16 to 16."""
    min_scale: float
    max_scale: float
    log_deviation: float
    collapsed_share: float
    histogram: tuple


@dataclass(frozen=True)
class Conformality:
    """How conformal the map between two surfaces is. quasi_conformal: the ratio Q >= 1 of the
    singular values of the map of each face, 1 where it is conformal."""
    quasi_conformal: Distribution
    quasi_conformal_of_new_area: float
    length_cross_ratio: Length_cross_ratio_change
    scale: Area_distortion
    flipped_faces: int
    flipped_share: float


@dataclass(frozen=True)
class Mean_and_max:
    """Of errors at a boundary."""
    mean: float
    max: float


@dataclass(frozen=True)
class Mollification:
    """How the intrinsic triangulation was built; share 0: there is none."""
    share: float
    thin_faces: int
    longer_edges: int
    added_length: float
    flipped_edges: int
    measured_faces: int
    measured_area: float


@dataclass(frozen=True)
class Scales:
    """What control of scale did. bound 0: none; low, high: factors of lengths of 1 % and 99 % of the
    area; tip_low, tip_high: of .1 % and 99.9 %, bounded 1.5 times as wide; kept_norm,
    kept_correlation: of the realised rho with that asked for."""
    bound: float
    low: float
    high: float
    tip_low: float
    tip_high: float
    min: float
    max: float
    weight: float
    kept_norm: float
    kept_correlation: float


@dataclass(frozen=True)
class Realised_curvature:
    """The change of curvature, measured on the positions, smoothed and compared with the given rho:
    share of its norm, correlation, distance, the share of the area with the wrong sign."""
    share: float
    correlation: float
    distance: float
    wrong_sign: float
    seen_share: float
    judged_share: float


@dataclass(frozen=True)
class Class_snap_report(Report):
    """The numbers that verify a snap to a conformal class; the displacement is relative to the
    diagonal of the mesh."""
    fault: Optional[str]
    converged: bool
    iterations: int
    factorizations: int
    initial_length_cross_ratio: Length_cross_ratio_change
    length_cross_ratio: Length_cross_ratio_change
    displacement: float


@dataclass(frozen=True)
class Spin_seconds:
    """Wall clock seconds of each stage."""
    setup: float
    exactness: float
    assembly: float
    factorization: float
    eigenvectors: float
    reconstruction: float
    certificate: float


@dataclass(frozen=True)
class Limits:
    """The bounds of what counts as success."""
    residual: float
    closure: float
    direction_error: float
    gamma_radius: float
    realised_share: float
    kept_norm: float
    agreement: float
    opposition: float
    quasi_conformal: float
    flipped_share: float
    collapsed_share: float


@dataclass(frozen=True)
class Spin_report(Report):
    """The numbers that verify a spin transformation; curvatures in 1/length of the mesh.

    fault: why it is not what was asked for, or None. is_relaxed: the spins are those of a
    least-squares problem (with max_scale, or handles), and no eigenvector, which residual and gap
    are about. eigenvalue: gamma; rho + gamma was realised. residual: error estimate of the spins.
    closure_residual: how far the new edges are from those of a surface, relative. period_defect: how
    far handles are from closed. realised_share, missing_share: the norms of the rho' that the new
    surface has and of rho' - rho, both relative to the norm of rho.
    See Spin_report.h for every field.
    """
    fault: Optional[str]
    converged: bool
    cancelled: bool
    is_relaxed: bool
    is_unfinished: bool
    eigenvalue: float
    residual: float
    dirac_residual: float
    gap: float
    branch_gap: float
    overlap: float
    iterations: int
    substeps: int
    factorizations: int
    solves: int
    spectral_shift: float
    is_generalized: bool
    generalized_eigenvalue: float
    steps: int
    reached: float
    missing_share: float
    added_share: float
    period_defect: float
    realised_share: float
    direction_error: Mean_and_max
    radius: float
    limits_gamma: bool
    gamma_radius: float
    boundary_fault: Optional[str]
    has_positions: bool
    position_error: Mean_and_max
    mollification: Mollification
    scales: Scales
    realised_curvature: Optional[Realised_curvature]
    exact_class: Optional[Class_snap_report]
    closure_residual: float
    conformality: Conformality
    min_spin_ratio: float
    collar: Optional[Conformality]
    seconds: Spin_seconds
    limits: Limits


@dataclass(frozen=True)
class Enclosure:
    """The area of a closed surface, the volume that it encloses, and this by that of the round
    sphere of the same area; 0 with a boundary."""
    area: float
    volume: float
    reduced_volume: float


@dataclass(frozen=True)
class Place:
    """Where a trial of a flow was rejected: the vertex where the reason is largest, the face there that has the
    least angle, and this angle in radians."""
    vertex: int
    face: int
    angle: float


@dataclass(frozen=True)
class Flow_step_report:
    """The numbers that verify one step of a flow; see Flow_report.h."""
    step: int
    accepted: bool
    stop: Optional[str]
    message: str
    place: Optional[Place]
    energy_before: float
    energy: float
    energy_of_faces: float
    is_bounded: bool
    faired: bool
    time_step: float
    trials: int
    direction_norm: float
    direction_norm_after: float
    remaining_share: float
    period_defect: float
    spin: Spin_report
    quasi_conformal: Distribution
    length_cross_ratio: float
    seconds: float


@dataclass(frozen=True)
class Flow_report(Report):
    """The numbers that verify a whole flow: why it stopped, the energies before and after (the
    integral of H^2, 4 pi for a round sphere), how conformal it is from start to end; on the
    intrinsic Delaunay triangulation, and what ends in of_faces on F."""
    fault: Optional[str]
    stop: str
    converged: bool
    message: str
    place: Optional[Place]
    steps: Tuple[Flow_step_report, ...]
    initial_energy: float
    energy: float
    initial_energy_of_faces: float
    energy_of_faces: float
    conformality: Conformality
    conformality_of_faces: Conformality
    initial_enclosure: Enclosure
    enclosure: Enclosure
    missing_volume: float
    direction_norm: float
    scales: Scales
    bounded_steps: int
    conformal_type_change: float
    period_defect: float
    seconds: float


@dataclass(frozen=True)
class Parameterization_seconds:
    """Wall clock seconds of each stage."""
    setup: float
    assembly: float
    factorization: float
    eigenvector: float
    certificate: float


@dataclass(frozen=True)
class Overlap_summary:
    """How much of the image covers what another part of it covers: the faces, and the common area of all pairs by
    the area of the image."""
    faces: int
    share: float


@dataclass(frozen=True)
class Parameterization_report(Report):
    """The numbers that verify a parameterization. It may have flipped faces, which are counted in conformality, and
    parts that overlap."""
    fault: Optional[str]
    converged: bool
    eigenvalue: float
    next_eigenvalue: float
    residual: float
    iterations: int
    boundary_loops: int
    normalized_vertices: int
    conformality: Conformality
    uniform_quasi_conformal: Distribution
    overlap: Overlap_summary
    seconds: Parameterization_seconds


def known(limits: Optional[Dict[str, float]]) -> Dict[str, float]:
    """The limits that a caller gives, if these are their names."""
    names = [field.name for field in fields(Limits)]
    for name in limits or {}:
        if name not in names:
            raise TypeError(f"there is no limit {name!r}, but {', '.join(names)}")
    return limits or {}


def flow_report(found: Dict[str, Any]) -> Flow_report:
    steps = tuple(build(Flow_step_report, step) for step in found["steps"])
    return build(Flow_report, {**found, "steps": steps})
