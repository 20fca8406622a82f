// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Target_mismatch.h>

#include <Conformal_geometry_processing/exceptions.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace Conformal_geometry_processing::internal {

/// twice the vector area of each face
Points double_vector_areas(const Mesh_view& mesh, const Points& p)
{
  Points areas(3, mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& [a, b, c] = mesh.corners(f);
    const Eigen::Vector3d ab = p.col(b) - p.col(a), ac = p.col(c) - p.col(a);
    areas.col(f) = ab.cross(ac);
  }
  return areas;
}

Target_mismatch::Target_mismatch(const Mesh_view& mesh, Points target, Eigen::VectorXd areas,
                                 double normal_weight, double tolerance)
    : m_target(std::move(target), mesh.corners()),
      m_frame(m_target.positions()),
      m_areas(std::move(areas)),
      m_normals(double_vector_areas(m_target, m_frame.to_frame(m_target.positions()))),
      m_normal_weight(normal_weight),
      m_tolerance(tolerance),
      m_source((*this)(mesh.positions()))
{
  const auto require = [](double x, const std::string& name) {
    if (!(x >= 0) || !std::isfinite(x))
      throw Precondition_error("Target_mismatch", name + " is " + std::to_string(x) +
                                                      ", it has to be finite and at least 0");
  };
  require(normal_weight, "the weight of normals");
  require(tolerance, "the tolerance of distances");
}

Target_mismatch::Value Target_mismatch::operator()(const Points& positions) const
{
  Value value{align(positions, m_target.positions(), m_areas)};
  const Points normals =
      double_vector_areas(m_target, m_frame.to_frame(value.alignment.apply(positions)));
  double squares = 0, area = 0;
  for (Eigen::Index f = 0; f < normals.cols(); ++f) {
    const double weight = m_normals.col(f).norm();
    area += weight;
    squares +=
        weight *
        (normals.col(f).stableNormalized() - m_normals.col(f).stableNormalized()).squaredNorm();
  }
  value.normals = area > 0 ? std::sqrt(squares / area) : 0;
  return value;
}

double Target_mismatch::sum(double d, double n) const
{
  const double least_distance = 1e-9, least_angle = 1e-3;
  d /= (std::max)(m_source.alignment.rms, least_distance);
  n /= (std::max)(m_source.normals, least_angle);
  return d * d + m_normal_weight * n * n;
}

bool Target_mismatch::is_reached(double d, double n) const
{
  const double turn = 100;
  return d <= m_tolerance && (m_normal_weight == 0 || n <= turn * m_tolerance);
}

}  // namespace Conformal_geometry_processing::internal
