// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Conformal_shape_space.h>

#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/calculus.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <cmath>

namespace Conformal_geometry_processing {

internal::Conformal_shape_space::Conformal_shape_space(const Mesh_view& mesh,
                                                       const std::string& function)
    : m_mesh(checked(mesh, function)), m_system(mesh, {}, function)
{
  m_system.prepare_response();
}

Eigen::VectorXd internal::Conformal_shape_space::response(const Eigen::VectorXd& phi) const
{
  const Eigen::VectorXd tangent = without_mean(phi);
  Quaternion_vector<double> source(tangent.size());
  for (Eigen::Index i = 0; i < source.size(); ++i) source[i] = {tangent[i], 0, 0, 0};
  Quaternion_vector<double> image = averaging(m_mesh) * source;
  const Eigen::VectorXd areas = face_areas(m_mesh);
  for (Eigen::Index f = 0; f < image.size(); ++f) image[f] *= areas[f];
  const Quaternion_vector<double> change =
      m_system.response(dirac(m_mesh).adjoint_times(image)).col(0);
  return components(change).row(0).transpose();
}

Eigen::VectorXd internal::Conformal_shape_space::shape_operator(const Eigen::VectorXd& phi) const
{
  return 2 / std::sqrt(m_system.areas().sum()) * response(phi);
}

double internal::Conformal_shape_space::second_order(const Eigen::VectorXd& phi) const
{
  return -m_system.areas().cwiseProduct(without_mean(phi)).dot(response(phi)) /
         m_system.areas().sum();
}

const Mesh_view& internal::Conformal_shape_space::checked(const Mesh_view& mesh,
                                                          const std::string& function)
{
  require_surface(mesh, function);
  require_closed(mesh, function);
  return mesh;
}

Eigen::VectorXd internal::Conformal_shape_space::without_mean(const Eigen::VectorXd& phi) const
{
  return phi.array() + first_order(phi);
}

}  // namespace Conformal_geometry_processing
