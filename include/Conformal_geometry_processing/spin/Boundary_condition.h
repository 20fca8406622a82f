// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_BOUNDARY_CONDITION_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_BOUNDARY_CONDITION_H

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief what is asked of a spin transformation at the boundary of a surface [CGP 4.5.4].
///
/// *Directions*: a direction U = t T + n N + b B of the boundary frame becomes a given one, V:
/// conjugate(lambda) U lambda = |lambda|^2 V. That is a linear condition, with two real degrees of
/// freedom left per vertex. The problem is elliptic unless U is the normal, and self-adjoint where
/// U is orthogonal to the tangent: then rho is realised up to a constant gamma. With tangents, any
/// rho is, if the target is a plane curve; otherwise one real condition on the targets is left,
/// and the solution is a least squares one: look at gamma.
///
/// *Free*: nothing is asked. Infinitely many surfaces are then solutions, for any rho; the one
/// nearest to the surface given is taken.
///
/// *Positions*: the boundary becomes a given curve, with given normals.
struct Boundary_condition {
  enum class Kind { free, directions, positions };

  Kind kind = Kind::free;
  /// coefficients (t, n, b) of U in the frame (T, N, B); need not have length one
  Eigen::Vector3d direction{1, 0, 0};
  /// directions V, which need not have length one, or positions; 3 x number of boundary vertices,
  /// in the order of `boundary_frames()`. No column: those of the surface itself, to be kept; of a
  /// surface that moves on, those that it has before each step. Those it had in the beginning would
  /// bring the discretisation errors of all steps back, and raise the energy again
  Points targets = Points(3, 0);
  Points normals = Points(3, 0);  ///< with positions

  static Boundary_condition free() { return {}; }

  static Boundary_condition tangents(Points targets = Points(3, 0));
  static Boundary_condition binormals(Points targets = Points(3, 0));
  static Boundary_condition directions(const Eigen::Vector3d& direction,
                                       Points targets = Points(3, 0));
  static Boundary_condition positions(Points targets, Points normals);

  /// whether D is self-adjoint with this condition, so that gamma is a true eigenvalue
  bool is_self_adjoint() const { return kind == Kind::directions && direction.x() == 0; }
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/Boundary_condition_impl.h>
#endif

#endif
