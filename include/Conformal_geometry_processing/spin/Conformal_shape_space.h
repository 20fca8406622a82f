// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Dirac_system.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

#include <string>

namespace Conformal_geometry_processing::internal {

/// \brief the space of conformal shapes near a surface: the hypersurface of the half-densities rho
/// |df| for which the Dirac equation has the eigenvalue zero [CGP 4.5.1].
///
/// Its normal at the surface is 1. It is curved: along rho = t phi with mean zero, gamma =
/// second_order(phi) t^2 + O(t^3). At round spheres, its principal curvatures are 1 / (sqrt(pi) k
/// (k + 1)) for the spherical harmonics of degree k.
///
/// Costs one factorization in the constructor and about five solves for each function.
class Conformal_shape_space {
 public:
  /// \param mesh must outlive the object
  /// \throw Precondition_error if the mesh is not a connected, closed, oriented manifold with
  /// finite coordinates and positive areas
  /// \throw Solver_error if the matrix cannot be factored
  explicit Conformal_shape_space(const Mesh_view& mesh,
                                 const std::string& function = "Conformal_shape_space");

  /// \brief the derivative of the logarithmic length, Re lambda-dot, where D lambda-dot = phi minus
  /// its mean: |V| numbers with mean zero.
  /// \param phi the change of rho, |V| numbers
  Eigen::VectorXd response(const Eigen::VectorXd& phi) const;

  /// \brief S(phi) = 2 A^(-1/2) Re lambda-dot, the shape operator of the space; |V| numbers in the
  /// unit of phi. Self-adjoint up to the discretisation error.
  Eigen::VectorXd shape_operator(const Eigen::VectorXd& phi) const;

  /// d gamma / dt for rho = t phi at t = 0: minus the mean of phi
  double first_order(const Eigen::VectorXd& phi) const
  {
    return -m_system.areas().dot(phi) / m_system.areas().sum();
  }

  /// half the second derivative of gamma: -<phi, Re lambda-dot> / A, never positive
  double second_order(const Eigen::VectorXd& phi) const;

 private:
  static const Mesh_view& checked(const Mesh_view& mesh, const std::string& function);
  Eigen::VectorXd without_mean(const Eigen::VectorXd& phi) const;

  const Mesh_view& m_mesh;
  Dirac_system m_system;
};

}  // namespace Conformal_geometry_processing::internal
