// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "spin/boundary_tools.h"

namespace cgp_test {

Complex complex_of(const Eigen::Vector3d& p)
{
  return {p.x(), p.y()};
}

Curvature_potential constant_potential(const Mesh_view& mesh, double c)
{
  return Curvature_potential::on_vertices(Eigen::VectorXd::Constant(mesh.size_of_vertices(), c));
}

Points enneper_directions(const Mesh_view& mesh, const Eigen::Vector3d& tnb)
{
  const auto differential = [](const Eigen::Vector3d& p, const Eigen::Vector3d& v) {
    return enneper_differential(p, v);
  };
  return image_directions(mesh, differential, tnb);
}

Eigen::Vector3d quadratic_map(const Eigen::Vector3d& p)
{
  const Complex F = complex_of(p) + .3 * complex_of(p) * complex_of(p);
  return {F.real(), F.imag(), 0};
}

Points quadratic_directions(const Mesh_view& mesh, const Eigen::Vector3d& tnb)
{
  const auto differential = [](const Eigen::Vector3d& p, const Eigen::Vector3d& v) {
    const Complex d = (1. + .6 * complex_of(p)) * complex_of(v);
    return Eigen::Vector3d(d.real(), d.imag(), 0);
  };
  return image_directions(mesh, differential, tnb);
}

double diagonal(const Points& p)
{
  return (p.rowwise().maxCoeff() - p.rowwise().minCoeff()).norm();
}

double rms_distance(const Points& a, const Points& b)
{
  return (a - b).norm() / std::sqrt(static_cast<double>(b.cols())) / diagonal(b);
}

double shape_error(const Points& a, const Points& b)
{
  return CGP::align(a, b).rms;
}

CGP::Spin_result transformed(const Mesh_view& mesh, const Boundary_condition& condition,
                             const Curvature_potential& rho, const CGP::Dirac_options& options)
{
  CGP::Spin_transformation transformation(mesh, {condition, std::nullopt});
  transformation.dirac() = options;
  return transformation.transform(rho);
}

double mean_Q(const CGP::Spin_result& r)
{
  return r.report.conformality.quasi_conformal.mean;
}

void expect_Q(const CGP::Spin_result& r, double Q)
{
  EXPECT_NEAR(mean_Q(r) - 1, Q - 1, .02 * (Q - 1));
}

double degrees(double radians)
{
  return 180 / pi * radians;
}

void expect_order(double order, const std::vector<double>& errors)
{
  std::vector<double> h;
  for (std::size_t i = 0; i < errors.size(); ++i) h.push_back(std::ldexp(1., -int(i)));
  const double found = slope(h, errors);
  EXPECT_NEAR(found, order, .05 * order * order);
}

}  // namespace cgp_test
