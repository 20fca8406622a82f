// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Dirac_linearization.h>

#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/potential_derivative.h>
#include <Conformal_geometry_processing/operators/sheet_loops.h>
#include <Conformal_geometry_processing/threads/parallel_loops.h>

#include <Eigen/Core>

#include <cstddef>
#include <utility>

namespace Conformal_geometry_processing::internal {

/// one value per sheet, each from `value(sheet)`
template <class Value>
Quaternion_vector<double> on_sheets(const Surface_ref& surface, const Value& value)
{
  const std::ptrdiff_t least = 1000;
  Quaternion_vector<double> z(surface.size_of_sheets());
  for_each_range(z.size(), least, [&](std::ptrdiff_t first, std::ptrdiff_t last) {
    for (std::ptrdiff_t s = first; s < last; ++s) z[s] = value(surface.sheet(static_cast<int>(s)));
  });
  return z;
}

Dirac_linearization::Dirac_linearization(const Surface_ref& surface, Curvature_potential rho,
                                         Spins lambda)
    : m_surface(surface), m_rho(std::move(rho)), m_lambda(std::move(lambda))
{}

auto Dirac_linearization::apply(const Spins& y) const -> Spins
{
  return on_sheets(m_surface, [&](const Sheet& sheet) {
    const Eigen::Vector3d r = m_rho.at_corners(sheet);
    Quaternion<double> image;
    for (int c = 0; c < 3; ++c)
      image += dirac_row(sheet, r, c) * y[sheet.corners[static_cast<std::size_t>(c)]];
    return image / sheet.area;
  });
}

auto Dirac_linearization::adjoint(const Spins& z) const -> Spins
{
  Spins y = Spins::Constant(m_lambda.size(), {});
  for_each_owned_range(m_surface.size_of_vertices(), [&](const Index_range& own) {
    for (int s = 0; s < m_surface.size_of_sheets(); ++s) {
      const Sheet sheet = m_surface.sheet(s);
      if (!own.touches(sheet)) continue;
      const Eigen::Vector3d r = m_rho.at_corners(sheet);
      for (int c = 0; c < 3; ++c)
        if (const int v = sheet.corners[static_cast<std::size_t>(c)]; own.contains(v))
          y[v] += sheet.share * (conjugate(dirac_row(sheet, r, c)) * z[s]);
    }
  });
  return y;
}

auto Dirac_linearization::turn(const Eigen::VectorXd& d) const -> Spins
{
  return on_sheets(m_surface, [&](const Sheet& sheet) {
    Quaternion<double> sum;
    for (std::size_t c = 0; c < 3; ++c)
      sum += d[potential_index(sheet, m_rho.on, c)] / 3 * m_lambda[sheet.corners[c]];
    return sum;
  });
}

Eigen::VectorXd Dirac_linearization::turned(const Spins& z) const
{
  Eigen::VectorXd d = Eigen::VectorXd::Zero(m_rho.values.size());
  for_each_owned_range(static_cast<int>(d.size()), [&](const Index_range& own) {
    for (int s = 0; s < m_surface.size_of_sheets(); ++s) {
      const Sheet sheet = m_surface.sheet(s);
      for (std::size_t c = 0; c < 3; ++c)
        if (const int i = potential_index(sheet, m_rho.on, c); own.contains(i))
          d[i] += sheet.share * sheet.area / 3 * dot(m_lambda[sheet.corners[c]], z[s]);
    }
  });
  return d;
}

double Dirac_linearization::squared_norm(const Spins& z) const
{
  double sum = 0;
  for (int s = 0; s < m_surface.size_of_sheets(); ++s) {
    const Sheet sheet = m_surface.sheet(s);
    sum += sheet.share * sheet.area * Conformal_geometry_processing::squared_norm(z[s]);
  }
  return sum;
}

}  // namespace Conformal_geometry_processing::internal
