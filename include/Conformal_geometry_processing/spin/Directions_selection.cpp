// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Directions_selection.h>

#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/spin/Dirac_misfit.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Quaternionic_linear_algebra/direct/Stopwatch.h>
#include <Quaternionic_linear_algebra/reduced/Reduced_hermitian_solver.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace Conformal_geometry_processing::internal {

Directions_selection::Directions_selection(Dirac_system& system, const Curvature_potential& rho,
                                           const Dirac_options& options)
    : m_system(system), m_rho(rho), m_options(options)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const bool is_eigenvalue = system.is_self_adjoint();
  const bool is_any = is_eigenvalue && options.branch != Dirac_options::Branch::zero;
  m_greatest_value = is_any ? infinity : greatest_misfit(system.surface());
  m_greatest_eigenvalue = is_eigenvalue ? greatest_zero(system.surface()) : infinity;
}

void Directions_selection::solve(Dirac_solution& s, const Go_further& go_further)
{
  Stopwatch watch;
  take(nearest_to_guide(s, go_further), s);
  s.eigenvalue = m_system.is_self_adjoint() ? dirac_quotient(m_system.surface(), m_rho, s.lambda)
                                            : dirac_misfit(m_system.surface(), m_rho, s.lambda);
  s.seconds.eigenvectors += watch.lap();
}

auto Directions_selection::kernel(Dirac_solution& s, const Go_further& go_further) const -> Vectors
{
  const int columns = 6, most = 4;
  const double tolerance = 1e-3, nothing = 1e-3 * std::sqrt(m_system.unit());
  Stopwatch watch;
  s.solves += columns - 1;  // of the noise
  const Eigensolver_result r =
      smallest(with_noise(guide(), columns), most, tolerance, s, go_further);
  const Dirac_misfit::Geometry geometry(m_system.surface());
  int size = 0;
  while (size < most) {
    const Misfit_sizes left = misfit_sizes(geometry, m_rho.values, r.vectors.col(size));
    if (!left.averages_out() && left.sheets > nothing) break;
    ++size;
  }
  s.seconds.eigenvectors += watch.lap();
  return r.vectors.leftCols(size);
}

Eigensolver_result Directions_selection::nearest_to_guide(Dirac_solution& s,
                                                          const Go_further& go_further) const
{
  // The guide may be an eigenvector itself, which gives no information about others.
  const bool is_one_enough =
      m_options.kernel_tolerance == 0 && m_options.branch != Dirac_options::Branch::smallest;
  const int columns = 4;
  Eigensolver_result r =
      smallest(guide(), 1, is_one_enough ? m_options.tolerance : 1e-2, s, go_further);
  if (s.cancelled || (is_one_enough && r.converged && is_solution(r, 0) &&
                      m_system.overlap(r.vectors.col(0), guide()) >= surely_taken()))
    return r;
  s.solves += columns - 1;  // of the noise
  r = smallest(with_noise(r.vectors, columns), columns, 1e-2, s, go_further);
  if (s.cancelled) return r;
  return smallest(r.vectors, wanted(r), m_options.tolerance, s, go_further);
}

Eigensolver_result Directions_selection::smallest(Vectors start, int wanted, double tolerance,
                                                  Dirac_solution& s,
                                                  const Go_further& go_further) const
{
  Eigensolver_options o;
  o.wanted = wanted;
  o.tolerance = tolerance;
  o.max_iterations = (std::max)(m_options.max_iterations - s.iterations, 1);
  o.scale = std::sqrt(m_system.unit());
  o.coefficients = Coefficients::reals;
  Eigensolver_result r =
      lobpcg(reduced_operator(m_system.matrix(), m_system.directions()->basis()),
             block_operator(m_system.areas()), inverse_operator(m_system.reduced_solver()),
             std::move(start), o, std::ref(go_further));
  s.iterations += r.iterations;
  s.solves += r.solves;
  s.cancelled = r.cancelled;
  return r;
}

auto Directions_selection::with_noise(const Vectors& first, int columns) const -> Vectors
{
  Vectors all(first.rows(), columns);
  all << first, m_system.noise(columns - first.cols(), m_options.random_seed);
  return all;
}

int Directions_selection::wanted(const Eigensolver_result& r) const
{
  return (std::max)(column(r), size_of_kernel(r) - 1) + 1;
}

double Directions_selection::singular_value(const Eigensolver_result& r, int c)
{
  return std::sqrt((std::max)(r.values[c], 0.));
}

bool Directions_selection::is_zero(const Eigensolver_result& r, int c) const
{
  if (std::isinf(m_greatest_eigenvalue)) return true;
  const Quaternion_vector<double> lambda = r.vectors.col(c);
  return std::abs(dirac_quotient(m_system.surface(), m_rho, lambda)) <= m_greatest_eigenvalue;
}

bool Directions_selection::is_solution(const Eigensolver_result& r, int c) const
{
  return singular_value(r, c) <= m_greatest_value &&
         (m_options.branch != Dirac_options::Branch::zero || is_zero(r, c));
}

int Directions_selection::column(const Eigensolver_result& r) const
{
  using Branch = Dirac_options::Branch;
  if (m_options.branch == Branch::smallest) return 0;
  const auto size = static_cast<int>(r.vectors.cols());
  const auto nearest_of = [&](const auto& is_candidate) {
    int best = -1;
    double most = -1;
    for (int c = 0; c < size; ++c)
      if (const double o = m_system.overlap(r.vectors.col(c), guide()); o > most && is_candidate(c))
        best = c, most = o;
    return best;
  };
  const int solution = nearest_of([&](int c) { return is_solution(r, c); });
  if (solution < 0 && m_options.branch == Branch::zero) return 0;
  const int nearest = solution >= 0 ? solution : nearest_of([](int) { return true; });
  if (m_system.overlap(r.vectors.col(nearest), guide()) >= surely_taken()) return nearest;
  const int zero = nearest_of([&](int c) { return is_solution(r, c) && is_zero(r, c); });
  return zero >= 0 ? zero : nearest;
}

double Directions_selection::surely_taken() const
{
  const double nearly_the_guide = .9;
  return m_system.is_self_adjoint() ? nearly_the_guide : surely_nearest;
}

int Directions_selection::size_of_kernel(const Eigensolver_result& r) const
{
  int size = 0;
  while (size < r.values.size() && singular_value(r, size) <= m_options.kernel_tolerance) ++size;
  return size;
}

double Directions_selection::gap(const Eigensolver_result& r, int first, int end) const
{
  const auto value = [&](int c) {
    return m_system.is_self_adjoint() ? dirac_quotient(m_system.surface(), m_rho,
                                                       Quaternion_vector<double>(r.vectors.col(c)))
                                      : singular_value(r, c);
  };
  const auto size = static_cast<int>(r.values.size());
  double least = std::numeric_limits<double>::infinity();
  for (int own = first; own < end && size > end - first; ++own)
    for (int c = 0; c < size; ++c)
      if (c < first || c >= end) least = (std::min)(least, std::abs(value(c) - value(own)));
  return std::isfinite(least) ? least : 0;
}

void Directions_selection::take(const Eigensolver_result& r, Dirac_solution& s) const
{
  const int nearest = column(r), kernel = size_of_kernel(r);
  s.lambda = r.vectors.col(nearest);
  s.residual = r.estimates[nearest];
  if (kernel > 1) {
    s.lambda.setConstant({});
    for (int c = 0; c < kernel; ++c) {
      const double share = inner_product(r.vectors.col(c), m_system.areas(), guide()).w;
      add_multiple(s.lambda, r.vectors.col(c), Quaternion<double>{share, 0, 0, 0});
    }
    s.residual = r.estimates.head(kernel).maxCoeff();
  }
  s.converged = s.residual <= m_options.tolerance;
  s.energy =
      inner_product(s.lambda, m_system.matrix() * s.lambda).w / m_system.squared_norm(s.lambda);
  s.gap = kernel > 1 ? gap(r, 0, kernel) : gap(r, nearest, nearest + 1);
  s.overlap = m_system.overlap(s.lambda, guide());
  // Takes the sign of the guide, but no rotation, because the directions are fixed.
  if (inner_product(guide(), m_system.areas(), s.lambda).w < 0) components(s.lambda) *= -1;
  s.lambda = m_system.normalized(std::move(s.lambda));
}

}  // namespace Conformal_geometry_processing::internal
