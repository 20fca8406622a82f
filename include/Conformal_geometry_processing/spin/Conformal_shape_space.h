// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_CONFORMAL_SHAPE_SPACE_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_CONFORMAL_SHAPE_SPACE_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/forms/Dirac_energy_solver.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Default_solver_traits.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/averaging.h>
#include <Conformal_geometry_processing/operators/dirac.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>

#include <cmath>
#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the space of conformal shapes around one: the hypersurface of the half-densities rho |df|
/// for which the Dirac equation has the eigenvalue zero [CGP 4.5.1].
///
/// Its normal at the shape is 1, and it is curved: along rho = t phi with mean zero,
/// gamma = second_order(phi) t^2 + O(t^3). Round spheres are the roundest: there the principal
/// curvatures are 1 / (sqrt(pi) k (k + 1)), of the spherical harmonics of degree k.
///
/// One factorization in the constructor, some five solves for each function.
/// \tparam SolverTraits a model of `SparseHermitianSolverTraits`
template <class SolverTraits = Default_solver_traits>
class Conformal_shape_space {
 public:
  /// \param mesh must outlive the object
  /// \throw Precondition_error if the mesh is not a connected, closed, oriented manifold with
  /// finite coordinates and positive areas \throw Solver_error if the matrix cannot be factored
  explicit Conformal_shape_space(const Mesh_view& mesh,
                                 const std::string& function = "Conformal_shape_space")
      : m_mesh(checked(mesh, function)), m_areas(vertex_areas(mesh)), m_solver(mesh)
  {}

  /// \brief the change of the logarithmic length, Re lambda-dot for D lambda-dot = phi without its
  /// mean: |V| numbers whose mean is zero.
  /// \param phi |V|, the change of rho
  Eigen::VectorXd response(const Eigen::VectorXd& phi) const
  {
    const Eigen::VectorXd tangent = without_mean(phi);
    Quaternion_vector<double> source(tangent.size());
    for (Eigen::Index i = 0; i < source.size(); ++i) source[i] = {tangent[i], 0, 0, 0};
    Quaternion_vector<double> image = averaging(m_mesh) * source;
    const Eigen::VectorXd areas = face_areas(m_mesh);
    for (Eigen::Index f = 0; f < image.size(); ++f) image[f] *= areas[f];
    const Quaternion_vector<double> change = m_solver(dirac(m_mesh).adjoint_times(image)).col(0);
    return components(change).row(0).transpose();
  }

  /// \brief S(phi) = 2 A^(-1/2) Re lambda-dot, the shape operator of the space; |V|, in the unit of
  /// phi. Self-adjoint up to the discretisation.
  Eigen::VectorXd shape_operator(const Eigen::VectorXd& phi) const
  {
    return 2 / std::sqrt(m_areas.sum()) * response(phi);
  }

  /// d gamma / dt for rho = t phi at t = 0: minus the mean of phi
  double first_order(const Eigen::VectorXd& phi) const { return -m_areas.dot(phi) / m_areas.sum(); }

  /// half of the second derivative of gamma: -<phi, Re lambda-dot> / A, not positive
  double second_order(const Eigen::VectorXd& phi) const
  {
    return -m_areas.cwiseProduct(without_mean(phi)).dot(response(phi)) / m_areas.sum();
  }

 private:
  static const Mesh_view& checked(const Mesh_view& mesh, const std::string& function)
  {
    require_surface(mesh, function);
    require_closed(mesh, function);
    return mesh;
  }

  Eigen::VectorXd without_mean(const Eigen::VectorXd& phi) const
  {
    return phi.array() + first_order(phi);
  }

  const Mesh_view& m_mesh;
  Eigen::VectorXd m_areas;  // |V|
  Dirac_energy_solver<SolverTraits> m_solver;
};

}  // namespace Conformal_geometry_processing

#endif
