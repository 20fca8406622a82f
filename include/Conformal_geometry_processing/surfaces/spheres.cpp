// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/surfaces/spheres.h>

#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>

#include <Eigen/Cholesky>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <vector>

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

/// Vertices (+-1, +-phi, 0) and cyclic permutations, faces counter-clockwise seen from outside
Mesh_view icosahedron()
{
  const double g = (1 + std::sqrt(5.)) / 2;
  Points p(3, 12);
  p << -1, 1, -1, 1, 0, 0, 0, 0, g, g, -g, -g,  //
      g, g, -g, -g, -1, 1, -1, 1, 0, 0, 0, 0,   //
      0, 0, 0, 0, g, g, -g, -g, -1, 1, -1, 1;
  return {std::move(p),
          {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

/// Numbers the points of evenly subdivided faces; points on edges are shared.
class Geodesic_points {
 public:
  /// \param frequency the number of parts of an edge
  explicit Geodesic_points(int frequency) : m_frequency(frequency), m_base(icosahedron()) {}

  const Mesh_view& base() const { return m_base; }
  Points points() const
  {
    return Eigen::Map<const Points>(m_points.front().data(), 3,
                                    static_cast<Eigen::Index>(m_points.size()));
  }

  /// The point with these barycentric coordinates, times the frequency, in face f
  int number(int f, const std::array<int, 3>& weights)
  {
    std::map<int, int> key;  // from corners to weights, without zero weights
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    for (std::size_t c = 0; c < 3; ++c) {
      if (weights[c] == 0) continue;
      key[m_base.corners(f)[c]] = weights[c];
      p += weights[c] * m_base.position(m_base.corners(f)[c]);
    }
    const auto [place, is_new] = m_numbers.emplace(key, static_cast<int>(m_points.size()));
    if (is_new) m_points.push_back((p / m_frequency).normalized());
    return place->second;
  }

 private:
  int m_frequency;
  Mesh_view m_base;
  std::vector<Eigen::Vector3d> m_points;
  std::map<std::map<int, int>, int> m_numbers;
};

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

Mesh_view geodesic_sphere(int frequency)
{
  if (frequency < 1)
    throw Precondition_error("geodesic_sphere", "the frequency is " + std::to_string(frequency) +
                                                    ", wanted at least one");
  internal::Geodesic_points points(frequency);
  Mesh_view::Corners corners;
  for (int f = 0; f < points.base().size_of_faces(); ++f)
    for (int i = 0; i < frequency; ++i)
      for (int j = 0; j < frequency - i; ++j) {
        const int k = frequency - i - j;
        const int a = points.number(f, {k, i, j}), b = points.number(f, {k - 1, i + 1, j}),
                  c = points.number(f, {k - 1, i, j + 1});
        corners.push_back({a, b, c});
        if (k > 1) corners.push_back({b, points.number(f, {k - 2, i + 1, j + 1}), c});
      }
  return {points.points(), std::move(corners)};
}

}  // namespace Conformal_geometry_processing
