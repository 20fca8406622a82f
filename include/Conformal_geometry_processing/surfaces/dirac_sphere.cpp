// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/surfaces/dirac_sphere.h>

#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Quaternionic_linear_algebra/algebra/stable_norm.h>

#include <Eigen/Cholesky>

#include <cmath>
#include <cstdlib>

namespace Conformal_geometry_processing {

namespace internal {

double normalized_legendre(int l, int m, double cosine, double sine)
{
  const double pi = std::acos(-1.);
  double value = std::sqrt((2 * m + 1) / (4 * pi));
  for (int i = 1; i <= m; ++i) value *= -sine * std::sqrt((2. * i - 1) / (2. * i));
  double before = 0;
  for (int n = m + 1; n <= l; ++n) {
    const double a = std::sqrt((4. * n * n - 1) / (n * n - m * m));
    const double b = std::sqrt(((n - 1.) * (n - 1) - m * m) / (4. * (n - 1) * (n - 1) - 1));
    const double next = a * (cosine * value - b * before);
    before = value;
    value = next;
  }
  return value;
}

}  // namespace internal

std::complex<double> spherical_harmonic(int l, int m, const Eigen::Vector3d& point)
{
  const int order = std::abs(m);
  if (order > l) return 0;
  const Eigen::Vector3d p = stable_normalized(point);
  const double sine = std::hypot(p.x(), p.y());
  const double longitude = std::atan2(p.y(), p.x());
  const double size = internal::normalized_legendre(l, order, p.z(), sine);
  const std::complex<double> Y = std::polar(1., order * longitude) * size;
  if (m >= 0) return Y;
  return order % 2 == 0 ? std::conj(Y) : -std::conj(Y);
}

void require_spherical_spinor(int kappa, int s, const std::string& function)
{
  if (kappa == 0) throw Precondition_error(function, "kappa is zero; any other integer is wanted");
  if (s < -std::abs(kappa) || s >= std::abs(kappa))
    throw Precondition_error(function, "s is " + std::to_string(s) + "; wanted " +
                                           std::to_string(-std::abs(kappa)) + " to " +
                                           std::to_string(std::abs(kappa) - 1) + " for kappa " +
                                           std::to_string(kappa));
}

Quaternion<double> spherical_spinor(int kappa, int s, const Eigen::Vector3d& point)
{
  const int l = kappa > 0 ? kappa : -kappa - 1;
  const double sign = kappa > 0 ? -1 : 1;
  // mu - 1/2 = s, mu + 1/2 = s + 1
  const double a = sign * std::sqrt((kappa - s) / (2. * kappa + 1));
  const double b = std::sqrt((kappa + s + 1) / (2. * kappa + 1));
  const std::complex<double> psi_1 = a * spherical_harmonic(l, s, point);
  const std::complex<double> psi_2 = b * spherical_harmonic(l, s + 1, point);
  return {psi_2.real(), -psi_1.imag(), -psi_1.real(), psi_2.imag()};
}

namespace internal {

/// Returns the centre of the best-fitting sphere, by least squares of |p - c|^2 - r^2.
/// \pre positions are of moderate size
Eigen::Vector3d center_of_sphere(const Points& positions)
{
  const Eigen::Vector3d mean = positions.rowwise().mean();
  const Points p = positions.colwise() - mean;
  const Eigen::RowVectorXd squares = p.colwise().squaredNorm();
  // 2 <p, c> - squares is constant, so the covariance of p with its squares determines c.
  const Eigen::Matrix3d A = 2 * p * p.transpose();
  const Eigen::Vector3d b = p * squares.transpose();
  return mean + A.ldlt().solve(b);
}

}  // namespace internal

Points directions_on_sphere(const Mesh_view& mesh, const std::string& function)
{
  require_not_empty(mesh, function);
  require_finite_positions(mesh, function);
  const Mesh_view framed = internal::in_own_frame(mesh);
  const Eigen::Vector3d center = internal::center_of_sphere(framed.positions());
  Points directions = framed.positions().colwise() - center;
  const double radius = directions.colwise().norm().mean();
  internal::refuse_if_any(
      mesh.size_of_vertices(),
      [&](int v) { return !(std::abs(directions.col(v).norm() - radius) <= 1e-3 * radius); },
      internal::name_of_vertex, function, "#vertex away from the sphere",
      "a round sphere is needed");
  if (signed_volume(framed) < 0)
    throw Precondition_error(function, "the normals point inward; turn the faces around");
  return directions / radius;
}

Spin_result surface_of_spin(const Mesh_view& mesh, Quaternion_vector<double> lambda,
                            const std::string& function, const Spin_solvers& solvers)
{
  Spin_transformation_options own;
  own.solvers = solvers;
  Spin_transformation transformation(mesh, own, function);
  if (lambda.size() == mesh.size_of_vertices()) fix_gauge(lambda, vertex_areas(mesh));
  Spin_result result = transformation.integrate(std::move(lambda));
  result.report.eigenvalue = dirac_quotient(mesh, no_potential(mesh), result.lambda);
  return result;
}

Spin_result spin_to_dirac_sphere(const Mesh_view& mesh, int kappa, int s,
                                 const std::string& function, const Spin_solvers& solvers)
{
  require_spherical_spinor(kappa, s, function);
  require_surface(mesh, function);
  require_closed(mesh, function);
  const Points p = directions_on_sphere(mesh, function);
  Quaternion_vector<double> lambda(p.cols());
  for (Eigen::Index v = 0; v < p.cols(); ++v) lambda[v] = spherical_spinor(kappa, s, p.col(v));
  return surface_of_spin(mesh, std::move(lambda), function, solvers);
}

Spin_result dirac_disk(const Mesh_view& mesh, double wanted, const Dirac_options& options,
                       const std::string& function)
{
  Spin_transformation_options own{Boundary_condition::binormals()};
  own.dirac = options;
  own.dirac.branch = Dirac_options::Branch::smallest;
  const auto rho =
      Curvature_potential::on_vertices(Eigen::VectorXd::Constant(mesh.size_of_vertices(), wanted));
  Spin_result result = Spin_transformation(mesh, own, function).transform(rho);
  result.report.limits.map.flipped_share = 0;
  return result;
}

}  // namespace Conformal_geometry_processing
