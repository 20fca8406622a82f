// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/forms/exactness_functions.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Solver_ref.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>
#include <Conformal_geometry_processing/spin/Scale_control.h>

#include <optional>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// options of `Spin_transformation` for boundaries, handles and thin faces
struct Spin_transformation_options {
  Boundary_condition boundary = {};  ///< for surfaces with boundary; the default is a free one
  /// how the edges are kept exact around handles and holes, see `exactness_constraints()`; if
  /// empty, the surface is sheared where they do not close up
  std::optional<Exactness> exactness = Exactness::adjoint;
  /// admits faces of any thinness, also of area zero: solves the equation on the intrinsic Delaunay
  /// triangulation, and adds to all edges the length that thin faces lack to form triangles, at
  /// most this share of the mean length, 0 < share < 1; 1e-6 is a good value
  std::optional<double> mollification = std::nullopt;
  /// the largest part of the edges, all steps together, that may fail to close up around handles
  /// and holes; none: a quarter of the discretisation error, which falls with the edge length, see
  /// `internal::Period_limit`
  std::optional<double> max_period_defect = std::nullopt;
  /// with a bound on the change of lengths, rho is replaced by the nearest one that keeps to it
  internal::Scale_control scales = {};
  /// whether `transform()` ends with the nearest surface whose length cross-ratios are those of the
  /// mesh, up to rounding; with mollification, of its intrinsic Delaunay triangulation. Cannot be
  /// combined with prescribed positions. See `internal::move_to_class()`
  bool exact_conformal_class = false;
  Spin_solvers solvers = {};  ///< for the linear systems
};

namespace internal {

/// \ingroup PkgSpin
/// \brief the bound on lengths where the caller gives none: `default_scale_bound`, or
/// `default_bound_of_wanted_scales` if there are wanted factors; no bound where the boundary has
/// prescribed positions or directions, which fix scales.
inline std::optional<double> default_bound(const Spin_transformation_options& options)
{
  if (options.boundary.targets.cols() > 0) return std::nullopt;
  return options.scales.factors.size() > 0 ? default_bound_of_wanted_scales : default_scale_bound;
}

}  // namespace internal

}  // namespace Conformal_geometry_processing
