// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_REDUCED_DIRAC_EQUATION_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_REDUCED_DIRAC_EQUATION_TEMPLATES_H

#include <Conformal_geometry_processing/algebra/random_quaternions.h>
#include <Conformal_geometry_processing/linear_algebra/reduced/reduced_operators.h>
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/operators/dirac_forms.h>
#include <Conformal_geometry_processing/spin/Prescribed_directions.h>
#include <Conformal_geometry_processing/spin/Reduced_dirac_equation.h>
#include <Conformal_geometry_processing/spin/boundary_fault.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

template <class Problem, class Directions>
Reduced_dirac_equation<Problem, Directions>::Reduced_dirac_equation(Problem& problem,
                                                                    const Directions& directions)
    : m_problem(problem), m_directions(directions)
{
  check("analysis",
        m_solver.analyze_with_positions(problem.matrix().pattern(), directions.basis().rows(),
                                        problem.mesh().positions()));
}

template <class Problem, class Directions>
void Reduced_dirac_equation<Problem, Directions>::set_potential(const Curvature_potential& rho,
                                                                Dirac_solution::Seconds& seconds)
{
  m_problem.assemble(rho, seconds);
  Stopwatch watch;
  Solver_status status = factorize(1e-3);
  if (status == Solver_status::not_positive_definite) status = factorize(1e-2);
  check("factorization", status);
  seconds.factorization += watch.lap();
}

template <class Problem, class Directions>
auto Reduced_dirac_equation<Problem, Directions>::response(const Vectors& c) -> Vectors
{
  Dirac_solution::Seconds seconds;
  m_problem.assemble(no_potential(m_problem.mesh()), seconds);
  check("factorization", factorize(1e-6));
  Vectors y;
  check("solution", m_solver.solve(c, y));
  return y;
}

template <class Problem, class Directions>
void Reduced_dirac_equation<Problem, Directions>::solve(const Curvature_potential& rho,
                                                        bool is_self_adjoint,
                                                        const Dirac_options& options,
                                                        Dirac_solution& s,
                                                        const Go_further& go_further)
{
  set_potential(rho, s.seconds);
  Stopwatch watch;
  const double bound =
      is_self_adjoint ? std::numeric_limits<double>::infinity() : greatest_misfit(m_problem.mesh());
  const Eigensolver_result found = nearest_to_guide(options, bound, s, go_further);
  take(found, options, bound, s);
  s.eigenvalue = is_self_adjoint ? dirac_quotient(m_problem.mesh(), rho, s.lambda)
                                 : dirac_misfit(m_problem.mesh(), rho, s.lambda);
  s.seconds.eigenvectors += watch.lap();
}

template <class Problem, class Directions>
Solver_status Reduced_dirac_equation<Problem, Directions>::factorize(double share)
{
  return m_solver.factorize(m_problem.matrix(), share * m_problem.unit() * m_problem.areas(),
                            m_directions.basis());
}

template <class Problem, class Directions>
void Reduced_dirac_equation<Problem, Directions>::check(const char* step, Solver_status status)
{
  if (status != Solver_status::success)
    throw Solver_error("Reduced_dirac_equation",
                       std::string(step) + " of the reduced X failed: " + to_string(status));
}

template <class Problem, class Directions>
Eigensolver_result Reduced_dirac_equation<Problem, Directions>::nearest_to_guide(
    const Dirac_options& options, double bound, Dirac_solution& s,
    const Go_further& go_further) const
{
  const Quaternion_vector<double>& guide = m_directions.guide();
  // The guide may itself be an eigenvector, which says nothing about others.
  const bool is_one_enough = options.kernel_tolerance == 0 && options.branch == Branch::nearest;
  const int columns = 4;
  Eigensolver_result r =
      smallest(guide, 1, is_one_enough ? options.tolerance : 1e-2, options, s, go_further);
  if (s.cancelled || (is_one_enough && r.converged && singular_value(r, 0) <= bound &&
                      overlap(r.vectors.col(0), guide) >= surely_nearest))
    return r;
  r = smallest(with_noise(r.vectors, columns, options.random_seed), columns, 1e-2, options, s,
               go_further);
  if (s.cancelled) return r;
  return smallest(r.vectors, wanted(r, options, bound), options.tolerance, options, s, go_further);
}

template <class Problem, class Directions>
Eigensolver_result Reduced_dirac_equation<Problem, Directions>::smallest(
    Vectors start, int wanted, double tolerance, const Dirac_options& options, Dirac_solution& s,
    const Go_further& go_further) const
{
  Eigensolver_options o;
  o.wanted = wanted;
  o.tolerance = tolerance;
  o.max_iterations = (std::max)(options.max_iterations - s.iterations, 1);
  o.scale = std::sqrt(m_problem.unit());
  o.coefficients = Coefficients::reals;
  Eigensolver_result r = lobpcg(reduced_operator(m_problem.matrix(), m_directions.basis()),
                                block_operator(m_problem.areas()), inverse_operator(m_solver),
                                std::move(start), o, std::ref(go_further));
  s.iterations += r.iterations;
  s.cancelled = r.cancelled;
  return r;
}

template <class Problem, class Directions>
auto Reduced_dirac_equation<Problem, Directions>::with_noise(const Vectors& first, int columns,
                                                             unsigned seed) const -> Vectors
{
  const Vectors b = block_operator(m_problem.areas())(
      random_quaternions(first.rows(), columns - first.cols(), seed));
  Vectors x;
  check("solution", m_solver.solve(b, x));
  Vectors all(first.rows(), columns);
  all << first, x;
  return all;
}

template <class Problem, class Directions>
int Reduced_dirac_equation<Problem, Directions>::wanted(const Eigensolver_result& r,
                                                        const Dirac_options& options,
                                                        double bound) const
{
  return (std::max)(column(r, options, bound), size_of_kernel(r, options) - 1) + 1;
}

template <class Problem, class Directions>
double Reduced_dirac_equation<Problem, Directions>::singular_value(const Eigensolver_result& r,
                                                                   int c)
{
  return std::sqrt((std::max)(r.values[c], 0.));
}

template <class Problem, class Directions>
int Reduced_dirac_equation<Problem, Directions>::column(const Eigensolver_result& r,
                                                        const Dirac_options& options,
                                                        double bound) const
{
  int nearest = 0;
  if (options.branch == Branch::smallest) return nearest;
  const bool has_solution = singular_value(r, 0) <= bound;
  for (int c = 1; c < r.vectors.cols() && (!has_solution || singular_value(r, c) <= bound); ++c)
    if (overlap(r.vectors.col(c), m_directions.guide()) >
        overlap(r.vectors.col(nearest), m_directions.guide()))
      nearest = c;
  return nearest;
}

template <class Problem, class Directions>
int Reduced_dirac_equation<Problem, Directions>::size_of_kernel(const Eigensolver_result& r,
                                                                const Dirac_options& options) const
{
  int size = 0;
  while (size < r.values.size() &&
         std::sqrt((std::max)(r.values[size], 0.)) <= options.kernel_tolerance)
    ++size;
  return size;
}

template <class Problem, class Directions>
void Reduced_dirac_equation<Problem, Directions>::take(const Eigensolver_result& r,
                                                       const Dirac_options& options, double bound,
                                                       Dirac_solution& s) const
{
  const int nearest = column(r, options, bound), kernel = size_of_kernel(r, options);
  const Quaternion_vector<double>& guide = m_directions.guide();
  s.lambda = r.vectors.col(nearest);
  s.residual = r.estimates[nearest];
  if (kernel > 1) {
    s.lambda.setConstant({});
    for (int c = 0; c < kernel; ++c) {
      const double share = inner_product(r.vectors.col(c), m_problem.areas(), guide).w;
      add_multiple(s.lambda, r.vectors.col(c), Quaternion<double>{share, 0, 0, 0});
    }
    s.residual = r.estimates.head(kernel).maxCoeff();
  }
  s.converged = s.residual <= options.tolerance;
  s.energy =
      inner_product(s.lambda, m_problem.matrix() * s.lambda).w / m_problem.squared_norm(s.lambda);
  s.gap = nearest + 1 < r.values.size() ? std::sqrt((std::max)(r.values[nearest + 1], 0.)) -
                                              std::sqrt((std::max)(r.values[nearest], 0.))
                                        : 0;
  s.overlap = overlap(s.lambda, guide);
  normalize(s.lambda);
}

template <class Problem, class Directions>
void Reduced_dirac_equation<Problem, Directions>::normalize(Quaternion_vector<double>& lambda) const
{
  const double sign = inner_product(m_directions.guide(), m_problem.areas(), lambda).w < 0 ? -1 : 1;
  components(lambda) *= sign * std::sqrt(m_problem.areas().sum() / m_problem.squared_norm(lambda));
}

template <class Problem, class Directions>
double Reduced_dirac_equation<Problem, Directions>::overlap(
    const Quaternion_vector<double>& a, const Quaternion_vector<double>& b) const
{
  return std::abs(inner_product(a, m_problem.areas(), b).w) /
         std::sqrt(m_problem.squared_norm(a) * m_problem.squared_norm(b));
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class Reduced_dirac_equation<
    Dirac_eigenproblem<Default_solver_traits, Lobpcg_eigensolver_traits, Mesh_view>,
    Prescribed_directions<Default_solver_traits, Mesh_view>>;
extern template class Reduced_dirac_equation<
    Dirac_eigenproblem<Default_solver_traits, Lobpcg_eigensolver_traits, Delaunay_view>,
    Prescribed_directions<Default_solver_traits, Delaunay_view>>;

}  // namespace Conformal_geometry_processing
#endif

#endif
