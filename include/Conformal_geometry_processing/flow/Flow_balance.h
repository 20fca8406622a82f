// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/flow/Flow_options.h>
#include <Conformal_geometry_processing/flow/Moebius_balancing.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/algebra/Moebius_map.h>

#include <Eigen/Core>

#include <optional>
#include <string>

namespace Conformal_geometry_processing {

class Spin_transformation;

namespace internal {

/// \brief keeps a flow balanced as its options specify.
class Flow_balance {
 public:
  /// \param mesh the initial surface of the flow
  /// \param transformation of the mesh
  /// \param function named in exceptions
  /// \throw Precondition_error if a prescribed area is not positive, their number is not that of
  /// the vertices, or the canonical metric of a sphere is requested
  Flow_balance(const Mesh_view& mesh, const Flow_options& options,
               Spin_transformation& transformation, const std::string& function);

  /// \brief the term to be added to the curvature potential of a step, |V| numbers in 1/length;
  /// zero if balance is not kept by a potential.
  ///
  /// Must not be multiplied by the time step: the surface can return in a single step.
  Eigen::VectorXd potential(const Mesh_view& mesh) const;

  /// whether `inverted()` must be applied after a step
  bool is_by_inversion() const
  {
    return m_balancing && m_way == Flow_options::Balancing::inversion;
  }

  /// \brief the balanced image of the surface under sphere inversions, with its area and centroid.
  /// \pre `is_by_inversion()`
  Points inverted(Mesh_view mesh) const;

 private:
  Flow_options::Balancing m_way;
  std::optional<Moebius_balancing> m_balancing;
};

}  // namespace internal
}  // namespace Conformal_geometry_processing
