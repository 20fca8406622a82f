// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Dirac_misfit.h>

#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace Conformal_geometry_processing::internal {

/// the mean of |lambda|^2 at the corners
inline double mean_squared_norm(const std::array<int, 3>& corners,
                                const Quaternion_vector<double>& lambda)
{
  const auto& [a, b, c] = corners;
  return (squared_norm(lambda[a]) + squared_norm(lambda[b]) + squared_norm(lambda[c])) / 3;
}

Dirac_misfit::Geometry::Geometry(const Surface_ref& surface, const Surface_part& of)
    : part(of), areas(vertex_areas(surface))
{
  part.clear_others(areas);
  sheets.reserve(static_cast<std::size_t>(surface.size_of_sheets()));
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    sheets.push_back({sheet.corners,
                      sheet.area,
                      sheet.share,
                      {sheet.vectors.col(0) / 2, sheet.vectors.col(1) / 2}});
  }
}

Dirac_misfit::Dirac_misfit(const Geometry& geometry, const Misfit_weights& weights,
                           Eigen::VectorXd rho, Spins lambda)
    : m_geometry(&geometry),
      m_weights(weights),
      m_rho(std::move(rho)),
      m_lambda(std::move(lambda)),
      m_inverses(sheets() + m_lambda.size()),
      m_residual{}
{
  Eigen::Index i = 0;
  for (const Triangle& sheet : geometry.sheets)
    m_inverses[i++] = 1 / std::sqrt(mean_squared_norm(sheet.corners, m_lambda));
  for (const Quaternion<double>& q : m_lambda) m_inverses[i++] = 1 / norm(q);
  m_residual =
      image(m_lambda, [this](int s, const Quaternion<double>& r) { return m_inverses[s] * r; });
}

/// calls `visit(own, sheet, number)`, on several threads, for all sheets with a corner in a range
/// of vertices, in their order
template <class Visit>
void Dirac_misfit::for_each_owned_sheet(const Visit& visit) const
{
  for_each_owned_range(vertices(), [&](const Index_range& own) {
    int s = 0;
    for (const Triangle& sheet : m_geometry->sheets) {
      if (own.touches(sheet)) visit(own, sheet, s);
      ++s;
    }
  });
}

/// the product of an imaginary number and q
inline Quaternion<double> product(const Eigen::Vector3d& e, const Quaternion<double>& q)
{
  return {-e[0] * q.x - e[1] * q.y - e[2] * q.z, e[0] * q.w + e[1] * q.z - e[2] * q.y,
          e[1] * q.w + e[2] * q.x - e[0] * q.z, e[2] * q.w + e[0] * q.y - e[1] * q.x};
}

// D y, times the area. The edge vectors add up to zero.
inline Quaternion<double> integrated_dirac(const Dirac_misfit::Triangle& sheet,
                                           const Quaternion_vector<double>& y)
{
  const auto& [a, b, c] = sheet.corners;
  return product(sheet.half_edges[0], y[c] - y[a]) + product(sheet.half_edges[1], y[c] - y[b]);
}

inline Quaternion<double> mean_product(const Dirac_misfit::Triangle& sheet,
                                       const Eigen::VectorXd& d, const Quaternion_vector<double>& y)
{
  const auto& [a, b, c] = sheet.corners;
  const double third = 1. / 3;
  return third * d[a] * y[a] + third * d[b] * y[b] + third * d[c] * y[c];
}

// finish((D - rho) y), on sheets and at vertices, and N^T W of it
template <class Finish>
auto Dirac_misfit::image(const Spins& y, const Finish& finish) const -> Image
{
  const Eigen::Index n = sheets();
  Image r{Spins(m_inverses.size()), Eigen::VectorXd::Zero(y.size())};
  for (Eigen::Index v = 0; v < y.size(); ++v) r.misfit[n + v] = Quaternion<double>{};
  for_each_owned_sheet([&](const Index_range& own, const Triangle& sheet, int s) {
    const Quaternion<double> sum = integrated_dirac(sheet, y);
    const Quaternion<double> share = sheet.share / 3 * sum;
    for (const int v : sheet.corners)
      if (own.contains(v)) r.misfit[n + v] += share;
    const Quaternion<double> z = finish(s, 1 / sheet.area * sum - mean_product(sheet, m_rho, y));
    if (own.contains(*std::min_element(sheet.corners.begin(), sheet.corners.end())))
      r.misfit[s] = z;
    add_turned(own, sheet, s, z, r.turned);
  });
  for (Eigen::Index v = 0; v < vertices(); ++v) {
    Quaternion<double>& z = r.misfit[n + v];
    z = finish(static_cast<int>(n + v), 1 / m_geometry->areas[v] * z - m_rho[v] * y[v]);
    r.turned[v] += turned_at(v, z);
  }
  m_geometry->part.complete(components(r.misfit).rightCols(y.size()));
  return r;
}

// what a sheet adds to N^T W z
void Dirac_misfit::add_turned(const Index_range& own, const Triangle& sheet, int s,
                              const Quaternion<double>& z, Eigen::VectorXd& d) const
{
  const Quaternion<double> here =
      m_weights.sheets * sheet.share * sheet.area / 3 * m_inverses[s] * z;
  for (const int v : sheet.corners)
    if (own.contains(v)) d[v] += dot(m_lambda[v], here);
}

double Dirac_misfit::turned_at(Eigen::Index v, const Quaternion<double>& z) const
{
  return m_weights.vertices * m_geometry->areas[v] * m_inverses[sheets() + v] * dot(m_lambda[v], z);
}

// of |lambda|
double Dirac_misfit::growth(int i, const Spins& y) const
{
  if (i >= sheets()) return m_inverses[i] * dot(m_lambda[i - sheets()], y[i - sheets()]);
  const auto& [a, b, c] = m_geometry->sheets[static_cast<std::size_t>(i)].corners;
  return m_inverses[i] / 3 *
         (dot(m_lambda[a], y[a]) + dot(m_lambda[b], y[b]) + dot(m_lambda[c], y[c]));
}

auto Dirac_misfit::apply(const Spins& y) const -> Image
{
  return image(y, [&](int i, const Quaternion<double>& r) {
    return m_inverses[i] * (r - growth(i, y) * m_residual.misfit[i]);
  });
}

auto Dirac_misfit::adjoint(const Spins& z, const Eigen::VectorXd& d) const -> Spins
{
  const Eigen::Index n = sheets();
  Spins at_vertices(m_lambda.size()), y(m_lambda.size());
  for (Eigen::Index v = 0; v < y.size(); ++v) {
    const double inverse = m_inverses[n + v];
    at_vertices[v] = m_weights.vertices * inverse * (z[n + v] - d[v] * inverse * m_lambda[v]);
    const double g = dot(m_residual.misfit[n + v], at_vertices[v]) * inverse;
    y[v] = -m_geometry->areas[v] * (m_rho[v] * at_vertices[v] + g * m_lambda[v]);
  }
  for_each_owned_sheet([&](const Index_range& own, const Triangle& sheet, int s) {
    const auto& [a, b, c] = sheet.corners;
    const double inverse = m_inverses[s];
    const Quaternion<double> here = m_weights.sheets * sheet.share * inverse *
                                    (z[s] - inverse * mean_product(sheet, d, m_lambda));
    const Quaternion<double> sum =
        here + sheet.share / 3 * (at_vertices[a] + at_vertices[b] + at_vertices[c]);
    const Quaternion<double> first = product(sheet.half_edges[0], sum),
                             second = product(sheet.half_edges[1], sum);
    const double third = sheet.area / 3, g = third * inverse * dot(m_residual.misfit[s], here);
    const Quaternion<double> part = third * here;
    const auto add = [&](int v, const Quaternion<double>& turned) {
      if (own.contains(v)) y[v] += turned - m_rho[v] * part - g * m_lambda[v];
    };
    add(a, first);
    add(b, second);
    add(c, -(first + second));
  });
  return y;
}

double Dirac_misfit::squared_norm(const Spins& z) const
{
  using Conformal_geometry_processing::squared_norm;
  const Surface_part& part = m_geometry->part;
  double on_sheets = 0, at_vertices = 0;
  for (int s = 0; s < part.own_faces(sheets()); ++s) {
    const Triangle& sheet = m_geometry->sheets[static_cast<std::size_t>(s)];
    on_sheets += sheet.share * sheet.area * squared_norm(z[s]);
  }
  Eigen::Index i = sheets();
  for (const double area : m_geometry->areas) at_vertices += area * squared_norm(z[i++]);
  return part.sum(m_weights.sheets * on_sheets + m_weights.vertices * at_vertices);
}

Misfit_sizes misfit_sizes(const Dirac_misfit::Geometry& geometry, const Eigen::VectorXd& rho,
                          const Quaternion_vector<double>& lambda)
{
  const auto size = [&](double sheets, double vertices) {
    Misfit_weights weights;
    weights.sheets = sheets;
    weights.vertices = vertices;
    const Dirac_misfit misfit(geometry, weights, rho, lambda);
    return std::sqrt(misfit.squared_norm(misfit.residual().misfit) / geometry.areas.sum());
  };
  return {size(1, 0), size(0, 1)};
}

}  // namespace Conformal_geometry_processing::internal
