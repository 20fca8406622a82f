// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Counted_faces.h"

#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <cmath>

namespace conformal::mpi {

double dirac_misfit(const Distributed_mesh& mesh, const CGP::Curvature_potential& rho,
                    const CGP::Quaternion_vector<double>& lambda)
{
  const Counted_faces faces{mesh};
  const Eigen::VectorXd areas = CGP::vertex_areas(CGP::Surface_ref(faces));
  const double length = areas.dot(CGP::components(lambda).colwise().squaredNorm().transpose());
  const double own = CGP::dirac_misfit(faces, rho, lambda);
  return std::sqrt(sum(own * own * length) / sum(length));
}

double overlap(const Distributed_mesh& mesh, const Eigen::VectorXd& areas,
               const CGP::Quaternion_vector<double>& a, const CGP::Quaternion_vector<double>& b)
{
  Eigen::Vector4d product = Eigen::Vector4d::Zero();
  Eigen::Vector2d squares = Eigen::Vector2d::Zero();
  for (int v = 0; v < mesh.own_vertices(); ++v) {
    const CGP::Quaternion<double> q = CGP::conjugate(a[v]) * b[v];
    product += areas[v] * Eigen::Vector4d(q.w, q.x, q.y, q.z);
    squares += areas[v] * Eigen::Vector2d(CGP::squared_norm(a[v]), CGP::squared_norm(b[v]));
  }
  return sum_of(product).norm() / std::sqrt(sum_of(squares).prod());
}

}  // namespace conformal::mpi
