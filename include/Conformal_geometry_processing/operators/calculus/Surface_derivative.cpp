// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/operators/calculus/Surface_derivative.h>

#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/operators/dirac.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

Quaternion_vector<double> as_quaternions(const Eigen::VectorXd& numbers)
{
  Quaternion_vector<double> q(numbers.size());
  for (Eigen::Index i = 0; i < q.size(); ++i) q[i] = {numbers[i], 0, 0, 0};
  return q;
}

Quaternion_vector<double> as_quaternions(const Points& vectors)
{
  Quaternion_vector<double> q(vectors.cols());
  for (Eigen::Index i = 0; i < q.size(); ++i) q[i] = imaginary(vectors.col(i));
  return q;
}

internal::Surface_derivative::Surface_derivative(const Mesh_view& mesh)
    : m_mesh(mesh), m_D(dirac(mesh)), m_normals(face_normals(mesh)), m_areas(face_areas(mesh))
{}

Quaternion_vector<double> internal::Surface_derivative::adjoint(Quaternion_vector<double> q) const
{
  for (Eigen::Index f = 0; f < q.size(); ++f) q[f] *= m_areas[f];
  Quaternion_vector<double> p = m_D.adjoint_times(q);
  const Eigen::VectorXd areas = vertex_areas(m_mesh);
  for (Eigen::Index v = 0; v < p.size(); ++v) p[v] *= 1 / areas[v];
  return p;
}

Eigen::VectorXd internal::Surface_derivative::real_part(const Quaternion_vector<double>& q)
{
  return components(q).row(0).transpose();
}

Eigen::VectorXd internal::Surface_derivative::normal_part(const Quaternion_vector<double>& q) const
{
  return components(q).bottomRows<3>().cwiseProduct(m_normals).colwise().sum().transpose();
}

Points internal::Surface_derivative::tangential_part(const Quaternion_vector<double>& q) const
{
  return components(q).bottomRows<3>() - m_normals * normal_part(q).asDiagonal();
}

}  // namespace Conformal_geometry_processing
