// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Reduced_basis.h>
#include <Conformal_geometry_processing/algebra/stable_norm.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Dirichlet_solver.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Solver_ref.h>
#include <Conformal_geometry_processing/mesh/Boundary_frames.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>

#include <Eigen/Core>

#include <memory>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief the space of spins that turn a direction of the boundary frames into prescribed
/// directions, with a smooth member, the guide, to which solutions are compared.
///
/// At the boundary, the guide consists of the rotations into the targets that twist least along the
/// boundary and are nearest to the best common rotation of the whole surface; inside it is
/// harmonic. If the problem has several solutions, the one nearest to the guide turns the surface
/// least.
///
class Prescribed_directions {
 public:
  /// \param surface must outlive the object; its positions may change
  /// \param condition of kind `directions`, with or without targets
  /// \param solver of the same traits; its symbolic analysis is shared
  Prescribed_directions(const Surface_ref& surface, const Boundary_condition& condition,
                        std::shared_ptr<const Sparse_pattern> pattern,
                        const Solver_ref<Quaternion<double>>& solver)
      : m_surface(surface),
        m_frames(boundary_frames(surface)),
        m_coefficients(stable_normalized(condition.direction)),
        m_has_targets(condition.targets.cols() > 0),
        m_targets(normalized(condition.targets)),
        m_L(pattern),
        m_harmonic(std::move(pattern), m_frames.vertices, solver)
  {
    update();
  }

  /// adopts new positions of the mesh; given targets are kept, otherwise the targets are the new
  /// directions of the mesh
  void update_geometry();

  const std::vector<int>& vertices() const { return m_frames.vertices; }

  /// the space of lambda
  const Reduced_basis<double>& basis() const { return m_basis; }

  /// the guide, |V|, an element of the space
  const Quaternion_vector<double>& guide() const { return m_guide; }

  /// unit vectors, 3 x number of `vertices()`
  const Points& targets() const { return m_targets; }

  /// \brief the angle in radians between the direction of the boundary frames of a surface of the
  /// same connectivity and the target, at each of `vertices()`.
  Eigen::VectorXd errors(const Surface_ref& surface, const Points& targets) const;

 private:
  static Points normalized(Points v);
  Points sources() const;
  void update();
  Block<Quaternion<double>> harmonic_extension(const std::vector<Quaternion<double>>& rotors);

  Surface_ref m_surface;
  Boundary_frames m_frames;
  Eigen::Vector3d m_coefficients;  // of U
  bool m_has_targets;
  Points m_targets;  // V, unit vectors
  Hermitian_sparse_matrix<double> m_L;
  Dirichlet_solver<double> m_harmonic;
  Reduced_basis<double> m_basis;
  Quaternion_vector<double> m_guide;
};

}  // namespace Conformal_geometry_processing::internal
