// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRECTIONS_SEARCH_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRECTIONS_SEARCH_TEMPLATES_H

#include <Conformal_geometry_processing/linear_algebra/direct/Stopwatch.h>
#include <Conformal_geometry_processing/linear_algebra/reduced/reduced_operators.h>
#include <Conformal_geometry_processing/operators/dirac_forms.h>
#include <Conformal_geometry_processing/spin/Dirac_system_templates.h>
#include <Conformal_geometry_processing/spin/Directions_search.h>
#include <Conformal_geometry_processing/spin/boundary_fault.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

template <class SolverTraits>
void Directions_search<SolverTraits>::solve(const Curvature_potential& rho,
                                            const Dirac_options& options, Dirac_solution& s,
                                            const Go_further& go_further)
{
  Stopwatch watch;
  const bool is_self_adjoint = m_system.is_self_adjoint();
  const double bound = is_self_adjoint ? std::numeric_limits<double>::infinity()
                                       : greatest_misfit(m_system.surface());
  const Eigensolver_result found = nearest_to_guide(options, bound, s, go_further);
  take(rho, found, options, bound, s);
  s.eigenvalue = is_self_adjoint ? dirac_quotient(m_system.surface(), rho, s.lambda)
                                 : dirac_misfit(m_system.surface(), rho, s.lambda);
  s.seconds.eigenvectors += watch.lap();
}

template <class SolverTraits>
Eigensolver_result Directions_search<SolverTraits>::nearest_to_guide(
    const Dirac_options& options, double bound, Dirac_solution& s,
    const Go_further& go_further) const
{
  // The guide may be an eigenvector itself, which gives no information about others.
  const bool is_one_enough =
      options.kernel_tolerance == 0 && options.branch == Dirac_options::Branch::nearest;
  const int columns = 4;
  Eigensolver_result r =
      smallest(guide(), 1, is_one_enough ? options.tolerance : 1e-2, options, s, go_further);
  if (s.cancelled || (is_one_enough && r.converged && singular_value(r, 0) <= bound &&
                      m_system.overlap(r.vectors.col(0), guide()) >= surely_nearest))
    return r;
  r = smallest(with_noise(r.vectors, columns, options.random_seed), columns, 1e-2, options, s,
               go_further);
  if (s.cancelled) return r;
  return smallest(r.vectors, wanted(r, options, bound), options.tolerance, options, s, go_further);
}

template <class SolverTraits>
Eigensolver_result Directions_search<SolverTraits>::smallest(Vectors start, int wanted,
                                                             double tolerance,
                                                             const Dirac_options& options,
                                                             Dirac_solution& s,
                                                             const Go_further& go_further) const
{
  Eigensolver_options o;
  o.wanted = wanted;
  o.tolerance = tolerance;
  o.max_iterations = (std::max)(options.max_iterations - s.iterations, 1);
  o.scale = std::sqrt(m_system.unit());
  o.coefficients = Coefficients::reals;
  Eigensolver_result r =
      lobpcg(reduced_operator(m_system.matrix(), m_system.directions()->basis()),
             block_operator(m_system.areas()), inverse_operator(m_system.reduced_solver()),
             std::move(start), o, std::ref(go_further));
  s.iterations += r.iterations;
  s.cancelled = r.cancelled;
  return r;
}

template <class SolverTraits>
auto Directions_search<SolverTraits>::with_noise(const Vectors& first, int columns,
                                                 unsigned seed) const -> Vectors
{
  Vectors all(first.rows(), columns);
  all << first, m_system.noise(columns - first.cols(), seed);
  return all;
}

template <class SolverTraits>
int Directions_search<SolverTraits>::wanted(const Eigensolver_result& r,
                                            const Dirac_options& options, double bound) const
{
  return (std::max)(column(r, options, bound), size_of_kernel(r, options) - 1) + 1;
}

template <class SolverTraits>
double Directions_search<SolverTraits>::singular_value(const Eigensolver_result& r, int c)
{
  return std::sqrt((std::max)(r.values[c], 0.));
}

template <class SolverTraits>
int Directions_search<SolverTraits>::column(const Eigensolver_result& r,
                                            const Dirac_options& options, double bound) const
{
  int nearest = 0;
  if (options.branch == Dirac_options::Branch::smallest) return nearest;
  const bool has_solution = singular_value(r, 0) <= bound;
  for (int c = 1; c < r.vectors.cols() && (!has_solution || singular_value(r, c) <= bound); ++c)
    if (m_system.overlap(r.vectors.col(c), guide()) >
        m_system.overlap(r.vectors.col(nearest), guide()))
      nearest = c;
  return nearest;
}

template <class SolverTraits>
int Directions_search<SolverTraits>::size_of_kernel(const Eigensolver_result& r,
                                                    const Dirac_options& options) const
{
  int size = 0;
  while (size < r.values.size() &&
         std::sqrt((std::max)(r.values[size], 0.)) <= options.kernel_tolerance)
    ++size;
  return size;
}

template <class SolverTraits>
double Directions_search<SolverTraits>::gap(const Curvature_potential& rho,
                                            const Eigensolver_result& r, int first, int end) const
{
  const auto value = [&](int c) {
    return m_system.is_self_adjoint() ? dirac_quotient(m_system.surface(), rho,
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

template <class SolverTraits>
void Directions_search<SolverTraits>::take(const Curvature_potential& rho,
                                           const Eigensolver_result& r,
                                           const Dirac_options& options, double bound,
                                           Dirac_solution& s) const
{
  const int nearest = column(r, options, bound), kernel = size_of_kernel(r, options);
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
  s.converged = s.residual <= options.tolerance;
  s.energy =
      inner_product(s.lambda, m_system.matrix() * s.lambda).w / m_system.squared_norm(s.lambda);
  s.gap = kernel > 1 ? gap(rho, r, 0, kernel) : gap(rho, r, nearest, nearest + 1);
  s.overlap = m_system.overlap(s.lambda, guide());
  // Takes the sign of the guide, but no rotation, because the directions are fixed.
  if (inner_product(guide(), m_system.areas(), s.lambda).w < 0) components(s.lambda) *= -1;
  s.lambda = m_system.normalized(std::move(s.lambda));
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class internal::Directions_search<Default_solver_traits>;

}  // namespace Conformal_geometry_processing
#endif

#endif
