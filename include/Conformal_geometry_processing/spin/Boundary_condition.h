// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>

#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the boundary condition of a spin transformation [CGP 4.5.4].
///
/// *Directions*: a direction U = t T + n N + b B of the boundary frame is mapped to a prescribed
/// direction V: conjugate(lambda) U lambda = |lambda|^2 V. This linear condition leaves two real
/// degrees of freedom per vertex. The problem is elliptic unless U is the normal, and self-adjoint
/// if U is orthogonal to the tangent: then rho is realised up to a constant gamma. With tangents,
/// any rho can be realised if the target is a plane curve; otherwise the targets must satisfy one
/// more real condition, and the solution is a least-squares solution with the misfit gamma.
///
/// *Free*: no condition. For any rho there are infinitely many solutions; the one nearest to the
/// given surface is taken.
///
/// *Positions*: the boundary becomes a given curve, with given normals. No conformal surface has
/// it, in general: the conformal distortion is minimised in the sense of least squares, and is what
/// the result is judged by [CGP 6.3.2]. With a finite weight, the boundary is attached to the
/// curve, and the distance from it is minimised together with the distortion. Closed curves inside
/// the surface may have positions and normals, too.
struct Boundary_condition {
  enum class Kind { free, directions, positions };

  Kind kind = Kind::free;
  /// coefficients (t, n, b) of U in the frame (T, N, B); of any nonzero length
  Eigen::Vector3d direction{1, 0, 0};
  /// directions V of any nonzero length, or positions; 3 x number of boundary vertices, in the
  /// order of `boundary_frames()`, and of the vertices of `curves` after them. No columns: the
  /// surface keeps its own directions; if it moves, those before each step
  Points targets = Points(3, 0);
  Points normals = Points(3, 0);  ///< of the given curve, with positions
  /// of positions against conformality: the curve pulls at the boundary in a layer of the width
  /// radius / weight; infinite: positions are exact
  double weight = std::numeric_limits<double>::infinity();
  /// with positions: closed curves inside the surface, each with its vertices in order
  std::vector<std::vector<int>> curves = {};

  static Boundary_condition free() { return {}; }

  static Boundary_condition tangents(Points targets = Points(3, 0));
  static Boundary_condition binormals(Points targets = Points(3, 0));
  static Boundary_condition directions(const Eigen::Vector3d& direction,
                                       Points targets = Points(3, 0));
  static Boundary_condition positions(Points targets, Points normals,
                                      double weight = std::numeric_limits<double>::infinity());

  /// whether D is self-adjoint with this condition, so that gamma is a true eigenvalue
  bool is_self_adjoint() const { return kind == Kind::directions && direction.x() == 0; }
};

/// \ingroup PkgSpin
/// the frames where a condition has values, in their order: of the boundary, then of its curves
internal::Boundary_frames frames_of(const Surface_ref& surface,
                                    const Boundary_condition& condition);

/// \ingroup PkgSpin
/// \brief checks that a condition fits the surface.
///
/// \throw Precondition_error if a condition other than `free` is set and there is no boundary; if
/// the number of targets or normals is not that of the boundary vertices; if one is zero or not
/// finite; if the direction is the normal (not elliptic), zero or not finite; if the boundary of
/// the surface folds back at a vertex, which then has no frame; if a curve has fewer than three
/// vertices, or one that is not inside the surface or is on it, or on another curve, twice
void require_condition(const Surface_ref& surface, const Boundary_condition& condition,
                       const std::string& function);

}  // namespace Conformal_geometry_processing
