// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Dirac_misfit.h>

#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/sheet_loops.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace Conformal_geometry_processing::internal {

double mean_squared_norm(const Sheet& sheet, const Quaternion_vector<double>& lambda)
{
  const auto& [a, b, c] = sheet.corners;
  return (squared_norm(lambda[a]) + squared_norm(lambda[b]) + squared_norm(lambda[c])) / 3;
}

Dirac_misfit::Geometry::Geometry(const Surface_ref& surface) : areas(vertex_areas(surface))
{
  sheets.reserve(static_cast<std::size_t>(surface.size_of_sheets()));
  for (int s = 0; s < surface.size_of_sheets(); ++s) sheets.push_back(surface.sheet(s));
}

Dirac_misfit::Dirac_misfit(const Geometry& geometry, const Misfit_weights& weights,
                           Eigen::VectorXd rho, Spins lambda)
    : m_geometry(&geometry),
      m_weights(weights),
      m_rho(std::move(rho)),
      m_lambda(std::move(lambda)),
      m_sizes(sheets() + m_lambda.size()),
      m_residual(Spins::Constant(m_sizes.size(), {}))
{
  for (int s = 0; s < sheets(); ++s)
    m_sizes[s] =
        std::sqrt(mean_squared_norm(geometry.sheets[static_cast<std::size_t>(s)], m_lambda));
  for (Eigen::Index v = 0; v < m_lambda.size(); ++v) m_sizes[sheets() + v] = norm(m_lambda[v]);
  image(m_lambda, m_residual);
  for (Eigen::Index i = 0; i < m_sizes.size(); ++i) m_residual[i] = m_residual[i] / m_sizes[i];
}

/// calls `visit(own, sheet, number)`, on several threads, for all sheets with a corner in a range
/// of vertices, in their order
template <class Visit>
void Dirac_misfit::for_each_owned_sheet(const Visit& visit) const
{
  for_each_owned_range(static_cast<int>(m_lambda.size()), [&](const Index_range& own) {
    int s = 0;
    for (const Sheet& sheet : m_geometry->sheets) {
      if (own.touches(sheet)) visit(own, sheet, s);
      ++s;
    }
  });
}

/// D y on a sheet, times its area
inline Quaternion<double> integrated_dirac(const Sheet& sheet, const Quaternion_vector<double>& y)
{
  Quaternion<double> sum;
  for (int c = 0; c < 3; ++c) {
    const double* const e = sheet.vectors.col(c).data();
    sum += Quaternion<double>{0, e[0] / -2, e[1] / -2, e[2] / -2} *
           y[sheet.corners[static_cast<std::size_t>(c)]];
  }
  return sum;
}

// (D - rho) y, on sheets and at vertices
void Dirac_misfit::image(const Spins& y, Spins& r) const
{
  const Eigen::Index n = sheets();
  for (Eigen::Index v = 0; v < y.size(); ++v) r[n + v] = Quaternion<double>{};
  for_each_owned_sheet([&](const Index_range& own, const Sheet& sheet, int s) {
    const Quaternion<double> sum = integrated_dirac(sheet, y);
    for (const int v : sheet.corners)
      if (own.contains(v)) r[n + v] += sheet.share / 3 * sum;
    if (!own.contains(sheet.corners[0])) return;
    const auto& [a, b, c] = sheet.corners;
    r[s] = sum / sheet.area - (m_rho[a] * y[a] + m_rho[b] * y[b] + m_rho[c] * y[c]) / 3.;
  });
  for (Eigen::Index v = 0; v < y.size(); ++v)
    r[n + v] = r[n + v] / m_geometry->areas[v] - m_rho[v] * y[v];
}

// of |lambda|
double Dirac_misfit::growth(const Sheet& sheet, int s, const Spins& y) const
{
  const auto& [a, b, c] = sheet.corners;
  return (dot(m_lambda[a], y[a]) + dot(m_lambda[b], y[b]) + dot(m_lambda[c], y[c])) /
         (3 * m_sizes[s]);
}

auto Dirac_misfit::apply(const Spins& y) const -> Spins
{
  Spins r(m_sizes.size());
  image(y, r);
  for (int s = 0; s < sheets(); ++s) {
    const double g = growth(m_geometry->sheets[static_cast<std::size_t>(s)], s, y);
    r[s] = (r[s] - g * m_residual[s]) / m_sizes[s];
  }
  for (Eigen::Index v = 0, i = sheets(); v < y.size(); ++v, ++i)
    r[i] = (r[i] - dot(m_lambda[v], y[v]) / m_sizes[i] * m_residual[i]) / m_sizes[i];
  return r;
}

auto Dirac_misfit::adjoint(const Spins& z) const -> Spins
{
  const Eigen::Index n = sheets();
  Spins at_vertices(m_lambda.size()), y(m_lambda.size());
  for (Eigen::Index v = 0; v < y.size(); ++v) {
    at_vertices[v] = m_weights.vertices / m_sizes[n + v] * z[n + v];
    const double g = dot(m_residual[n + v], at_vertices[v]) / m_sizes[n + v];
    y[v] = -m_geometry->areas[v] * (m_rho[v] * at_vertices[v] + g * m_lambda[v]);
  }
  for_each_owned_sheet([&](const Index_range& own, const Sheet& sheet, int s) {
    const auto& [a, b, c] = sheet.corners;
    const Quaternion<double> here = m_weights.sheets * sheet.share / m_sizes[s] * z[s];
    const Quaternion<double> sum =
        here + sheet.share / 3 * (at_vertices[a] + at_vertices[b] + at_vertices[c]);
    const double g = dot(m_residual[s], here) / m_sizes[s];
    for (int k = 0; k < 3; ++k) {
      const int v = sheet.corners[static_cast<std::size_t>(k)];
      if (!own.contains(v)) continue;
      const double* const e = sheet.vectors.col(k).data();
      y[v] += Quaternion<double>{0, e[0] / 2, e[1] / 2, e[2] / 2} * sum -
              sheet.area / 3 * (m_rho[v] * here + g * m_lambda[v]);
    }
  });
  return y;
}

auto Dirac_misfit::turn(const Eigen::VectorXd& d) const -> Spins
{
  const Eigen::Index n = sheets();
  Spins r(m_sizes.size());
  for (Eigen::Index s = 0; s < n; ++s) {
    const auto& [a, b, c] = m_geometry->sheets[static_cast<std::size_t>(s)].corners;
    r[s] = (d[a] * m_lambda[a] + d[b] * m_lambda[b] + d[c] * m_lambda[c]) / (3 * m_sizes[s]);
  }
  for (Eigen::Index v = 0; v < d.size(); ++v) r[n + v] = d[v] / m_sizes[n + v] * m_lambda[v];
  return r;
}

Eigen::VectorXd Dirac_misfit::turned(const Spins& z) const
{
  const Eigen::Index n = sheets();
  Eigen::VectorXd d(m_lambda.size());
  for (Eigen::Index v = 0; v < d.size(); ++v)
    d[v] = m_weights.vertices * m_geometry->areas[v] / m_sizes[n + v] * dot(m_lambda[v], z[n + v]);
  for_each_owned_sheet([&](const Index_range& own, const Sheet& sheet, int s) {
    const Quaternion<double> here =
        m_weights.sheets * sheet.share * sheet.area / (3 * m_sizes[s]) * z[s];
    for (const int v : sheet.corners)
      if (own.contains(v)) d[v] += dot(m_lambda[v], here);
  });
  return d;
}

double Dirac_misfit::squared_norm(const Spins& z) const
{
  using Conformal_geometry_processing::squared_norm;
  double on_sheets = 0, at_vertices = 0;
  Eigen::Index i = 0;
  for (const Sheet& sheet : m_geometry->sheets)
    on_sheets += sheet.share * sheet.area * squared_norm(z[i++]);
  for (const double area : m_geometry->areas) at_vertices += area * squared_norm(z[i++]);
  return m_weights.sheets * on_sheets + m_weights.vertices * at_vertices;
}

}  // namespace Conformal_geometry_processing::internal
