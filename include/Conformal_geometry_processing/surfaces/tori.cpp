// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/surfaces/tori.h>

#include <Quaternionic_linear_algebra/algebra/rotor.h>

namespace Conformal_geometry_processing {

Eigen::Vector3d stereographic_projection(const Quaternion<double>& q)
{
  return imaginary_part(q) / (1 - q.w);
}

Mesh_view round_torus(double R, double r, int m, int n)
{
  if (!(R > r && r > 0 && std::isfinite(R)))
    throw Precondition_error("round_torus", "the radii are " + std::to_string(R) + " and " +
                                                std::to_string(r) + ", wanted R > r > 0");
  const double s = r / R, c = std::sqrt((1 - s) * (1 + s)), turn = 2 * std::acos(-1.);
  return torus_grid(m, n, 0, [&](int i, int j) -> Eigen::Vector3d {
    const double u = turn * i / m, v = turn * j / n;
    return R * c *
           stereographic_projection(
               {s * std::cos(v), c * std::cos(u), c * std::sin(u), s * std::sin(v)});
  });
}

Mesh_view homogeneous_torus(double b, int n)
{
  if (!(b > 0) || !(b * n < 1e6))
    throw Precondition_error("homogeneous_torus",
                             "the modulus is " + std::to_string(b) + " i, wanted b positive");
  return round_torus(std::sqrt(1 + b * b), 1, static_cast<int>(std::round(b * n)), n);
}

Hopf_torus::Hopf_torus(const Points& curve, const std::string& function)
{
  const auto m = curve.cols();
  if (m < 3)
    throw Precondition_error(
        function, "the curve has " + std::to_string(m) + " points, wanted three at least");
  Eigen::Vector3d last = direction(curve, 0, function);
  m_lift.push_back(rotor<double>(Eigen::Vector3d::UnitZ(), last));
  m_places.push_back(0);
  for (Eigen::Index k = 1; k <= m; ++k) {
    const Eigen::Vector3d next = direction(curve, k % m, function);
    const double angle = std::atan2(last.cross(next).norm(), last.dot(next));
    if (!(angle > 1e-12 && angle < 3.14159265))
      throw Precondition_error(
          function, "point " + std::to_string(k % m) + " is the last one again, or opposite to it");
    m_lift.push_back(m_lift.back() * rotor(last, next));
    m_places.push_back(m_places.back() + angle);
    last = next;
  }
}

double Hopf_torus::area() const
{
  const double whole = 16 * std::atan(1.), A = 2 * std::fmod(-holonomy(), whole / 2);
  return A < 0 ? A + whole : A;
}

std::complex<double> Hopf_torus::modulus() const
{
  const double turn = 8 * std::atan(1.);
  return {area() / 2 / turn, length() / 2 / turn};
}

Mesh_view Hopf_torus::mesh(int n, const std::string& function) const
{
  const double turn = 8 * std::atan(1.), columns = n / turn;
  const int m = static_cast<int>(m_lift.size()) - 1;
  // The grid closes after an integral number of columns; the remaining shear is less than half a
  // column in total.
  const int shift = static_cast<int>(std::round(holonomy() * columns));
  const double shear = shift / columns - holonomy();
  return torus_grid(m, n, shift, [&](int i, int j) {
    const std::size_t row = static_cast<std::size_t>(i);
    const double x = j / columns + shear * m_places[row] / length();
    const Quaternion<double> q = Quaternion<double>{std::cos(x), 0, 0, std::sin(x)} * m_lift[row];
    // The fibre over that point consists of quaternions without i and j.
    if (!(q.x * q.x + q.y * q.y > 1e-20))
      throw Precondition_error(function,
                               "the curve goes through (0, 0, 1), which is sent to "
                               "infinity; turn the curve");
    return stereographic_projection(q);
  });
}

Eigen::Vector3d Hopf_torus::direction(const Points& curve, Eigen::Index k,
                                      const std::string& function)
{
  const double size = curve.col(k).stableNorm();
  if (!(size > 0) || !std::isfinite(size))
    throw Precondition_error(function,
                             "point " + std::to_string(k) + " of the curve is zero or not finite");
  return curve.col(k) / size;
}

double Hopf_torus::holonomy() const
{
  const Quaternion<double> e = m_lift.back() * conjugate(m_lift.front());
  return std::atan2(e.z, e.w);
}

}  // namespace Conformal_geometry_processing
