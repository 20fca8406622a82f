// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

#include "support/decompositions.h"
#include "support/dense.h"
#include "support/meshes.h"

/// The branch of the identity with dense real matrices, which share no code with the library's.
namespace cgp_test {

/// an eigenspace of X, with all that belongs to it
struct Dense_branch {
  Eigen::VectorXd root;   ///< of the areas, four times each
  Eigen::MatrixXd space;  ///< four orthonormal columns: the multiples of one vector by quaternions
  double gamma = 0, gap = 0;
  double least_overlap = 1;  ///< of two steps that follow one another

  /// |projection of v| / |v|
  double overlap(const Quaternion_vector<double>& v) const
  {
    const Eigen::VectorXd x =
        root.cwiseProduct(Conformal_geometry_processing::components(v).reshaped());
    return (space.transpose() * x).norm() / x.norm();
  }

  Quaternion_vector<double> vector() const
  {
    Quaternion_vector<double> v(root.size() / 4);
    const Eigen::VectorXd x = space.col(0).cwiseQuotient(root);
    for (Eigen::Index i = 0; i < v.size(); ++i)
      v[i] = {x[4 * i], x[4 * i + 1], x[4 * i + 2], x[4 * i + 3]};
    return v;
  }
};

inline Conformal_geometry_processing::Curvature_potential scaled(
    const Conformal_geometry_processing::Curvature_potential& rho, double t, double shift = 0)
{
  return {rho.on, (t * rho.values.array() + shift).matrix()};
}

/// moves to the eigenspace of X for rho + gamma that is nearest to the present one
inline void move_to(const Mesh_view& mesh,
                    const Conformal_geometry_processing::Curvature_potential& rho, Dense_branch& at)
{
  const Eigen::MatrixXd X = real_form(dense(dirac_energy(mesh, scaled(rho, 1, at.gamma))));
  const Eigen::VectorXd inverse = at.root.cwiseInverse();
  const Eigenpairs e = symmetric_eigenpairs(inverse.asDiagonal() * X * inverse.asDiagonal());
  Eigen::Index own = 0;
  double most = 0;
  for (Eigen::Index j = 0; j + 4 <= X.rows(); j += 4) {
    const double overlap = (e.vectors.middleCols(j, 4).transpose() * at.space.col(0)).norm();
    if (overlap > most) own = j;
    most = std::max(most, overlap);
  }
  at.least_overlap = std::min(at.least_overlap, most);
  at.space = e.vectors.middleCols(own, 4);
  at.gap = std::sqrt(e.values[own == 0 ? 4 : 0]);
  at.gamma = Conformal_geometry_processing::dirac_quotient(mesh, rho, at.vector());
}

/// rho is switched on in equal steps; at the end the shift becomes the quotient of its vector
inline Dense_branch dense_branch_of_identity(
    const Mesh_view& mesh, const Conformal_geometry_processing::Curvature_potential& rho, int steps)
{
  Dense_branch at;
  const Eigen::VectorXd areas = Conformal_geometry_processing::vertex_areas(mesh);
  at.root = areas.cwiseSqrt().transpose().replicate(4, 1).reshaped();
  at.space = Eigen::MatrixXd::Zero(at.root.size(), 4);
  for (Eigen::Index i = 0; i < at.root.size(); ++i)
    at.space(i, i % 4) = at.root[i] / std::sqrt(areas.sum());
  for (int k = 1; k <= steps; ++k) move_to(mesh, scaled(rho, double(k) / steps), at);
  for (int k = 0; k < 8; ++k) move_to(mesh, rho, at);
  return at;
}

}  // namespace cgp_test
