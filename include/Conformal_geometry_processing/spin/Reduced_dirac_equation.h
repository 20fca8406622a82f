// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_REDUCED_DIRAC_EQUATION_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_REDUCED_DIRAC_EQUATION_H

#include <Conformal_geometry_processing/algebra/random_quaternions.h>
#include <Conformal_geometry_processing/algebra/rotor.h>
#include <Conformal_geometry_processing/linear_algebra/krylov/Lobpcg.h>
#include <Conformal_geometry_processing/linear_algebra/reduced/Reduced_hermitian_solver.h>
#include <Conformal_geometry_processing/linear_algebra/reduced/reduced_operators.h>
#include <Conformal_geometry_processing/operators/dirac_forms.h>
#include <Conformal_geometry_processing/spin/Dirac_eigenproblem.h>
#include <Conformal_geometry_processing/spin/Prescribed_directions.h>
#include <Conformal_geometry_processing/spin/boundary_fault.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief solves (D - rho) lambda = gamma lambda for spins that turn directions at the boundary
/// into prescribed ones: the smallest singular value of D - rho on that space, or one of the next
/// whose vector is nearer to the guide [CGP 5.7]. Where gamma is only a misfit, no vector with a
/// great one is taken if there are others (`greatest_misfit()`).
///
/// The space is one over the real numbers, so eigenvalues are simple in general and not fourfold.
/// Per `solve()`: one factorization, and one solve for each iteration and column.
///
/// \tparam Problem a `Dirac_eigenproblem`
/// \tparam Directions `Prescribed_directions`
template <class Problem, class Directions>
class Reduced_dirac_equation {
  using Vectors = Block<Quaternion<double>>;

 public:
  /// squares of overlaps with orthogonal vectors add up to at most one, so that no other vector is
  /// nearer to the guide than one with this overlap
  static constexpr double surely_nearest = 0.75;

  /// \param problem, directions must outlive the object
  /// \throw Solver_error if the analysis fails
  Reduced_dirac_equation(Problem& problem, const Directions& directions)
      : m_problem(problem), m_directions(directions)
  {
    check("analysis",
          m_solver.analyze_with_positions(problem.matrix().pattern(), directions.basis().rows(),
                                          problem.mesh().positions()));
  }

  /// solves with R = B^T (X + shift) B for the last rho
  const Reduced_hermitian_solver& solver() const { return m_solver; }

  /// gives back the memory of the factor, until the next `solve()`
  void release() { m_solver.release(); }

  /// \brief assembles X for rho and factors R, shifted as `Dirac_eigenproblem` does.
  /// \throw Solver_error if R is not positive definite to rounding, or memory is short
  void set_potential(const Curvature_potential& rho, Dirac_solution::Seconds& seconds)
  {
    m_problem.assemble(rho, seconds);
    Stopwatch watch;
    Solver_status status = factorize(1e-3);
    if (status == Solver_status::not_positive_definite) status = factorize(1e-2);
    check("factorization", status);
    seconds.factorization += watch.lap();
  }

  /// \brief B R^-1 B^T c for rho = 0, with a shift so small that it counts along the kernel only:
  /// the change of lambda = 1 that answers to sources c.
  /// \throw Solver_error if R cannot be factored
  Vectors response(const Vectors& c)
  {
    Dirac_solution::Seconds seconds;
    m_problem.assemble(no_potential(m_problem.mesh()), seconds);
    check("factorization", factorize(1e-6));
    Vectors y;
    check("solution", m_solver.solve(c, y));
    return y;
  }

  /// \param[in,out] s is filled in
  /// \param is_self_adjoint whether gamma has a sign
  void solve(const Curvature_potential& rho, bool is_self_adjoint, const Dirac_options& options,
             Dirac_solution& s, const Go_further& go_further)
  {
    set_potential(rho, s.seconds);
    Stopwatch watch;
    const double bound = is_self_adjoint ? std::numeric_limits<double>::infinity()
                                         : greatest_misfit(m_problem.mesh());
    const Eigen_result found = nearest_to_guide(options, bound, s, go_further);
    take(found, options, bound, s);
    s.eigenvalue = is_self_adjoint ? dirac_quotient(m_problem.mesh(), rho, s.lambda)
                                   : dirac_misfit(m_problem.mesh(), rho, s.lambda);
    s.seconds.eigenvectors += watch.lap();
  }

 private:
  Solver_status factorize(double share)
  {
    return m_solver.factorize(m_problem.matrix(), share * m_problem.unit() * m_problem.areas(),
                              m_directions.basis());
  }

  static void check(const char* step, Solver_status status)
  {
    if (status != Solver_status::success)
      throw Solver_error("Reduced_dirac_equation",
                         std::string(step) + " of the reduced X failed: " + to_string(status));
  }

  /// One column, if it comes near to the guide; else several, of which those that count converge.
  Eigen_result nearest_to_guide(const Dirac_options& options, double bound, Dirac_solution& s,
                                const Go_further& go_further) const
  {
    const Quaternion_vector<double>& guide = m_directions.guide();
    // The guide may itself be an eigenvector, which says nothing about others.
    const bool is_one_enough = options.kernel_tolerance == 0 && options.branch == Branch::nearest;
    const int columns = 4;
    Eigen_result r =
        smallest(guide, 1, is_one_enough ? options.tolerance : 1e-2, options, s, go_further);
    if (s.cancelled || (is_one_enough && r.converged && singular_value(r, 0) <= bound &&
                        overlap(r.vectors.col(0), guide) >= surely_nearest))
      return r;
    r = smallest(with_noise(r.vectors, columns, options.random_seed), columns, 1e-2, options, s,
                 go_further);
    if (s.cancelled) return r;
    return smallest(r.vectors, wanted(r, options, bound), options.tolerance, options, s,
                    go_further);
  }

  Eigen_result smallest(Vectors start, int wanted, double tolerance, const Dirac_options& options,
                        Dirac_solution& s, const Go_further& go_further) const
  {
    Eigen_options o;
    o.wanted = wanted;
    o.tolerance = tolerance;
    o.max_iterations = (std::max)(options.max_iterations - s.iterations, 1);
    o.scale = std::sqrt(m_problem.unit());
    o.coefficients = Coefficients::reals;
    Eigen_result r = lobpcg(reduced_operator(m_problem.matrix(), m_directions.basis()),
                            block_operator(m_problem.areas()), inverse_operator(m_solver),
                            std::move(start), o, std::ref(go_further));
    s.iterations += r.iterations;
    s.cancelled = r.cancelled;
    return r;
  }

  /// the first columns and X^-1 of noise
  Vectors with_noise(const Vectors& first, int columns, unsigned seed) const
  {
    const Vectors b = block_operator(m_problem.areas())(
        random_quaternions(first.rows(), columns - first.cols(), seed));
    Vectors x;
    check("solution", m_solver.solve(b, x));
    Vectors all(first.rows(), columns);
    all << first, x;
    return all;
  }

  /// how many of the eigenvectors have to be exact
  int wanted(const Eigen_result& r, const Dirac_options& options, double bound) const
  {
    return (std::max)(column(r, options, bound), size_of_kernel(r, options) - 1) + 1;
  }

  static double singular_value(const Eigen_result& r, int c)
  {
    return std::sqrt((std::max)(r.values[c], 0.));
  }

  /// that of the branch: of those that are solutions up to the discretisation, if there are some
  int column(const Eigen_result& r, const Dirac_options& options, double bound) const
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

  /// the number of singular values that count as zero; of none, one is as good
  int size_of_kernel(const Eigen_result& r, const Dirac_options& options) const
  {
    int size = 0;
    while (size < r.values.size() &&
           std::sqrt((std::max)(r.values[size], 0.)) <= options.kernel_tolerance)
      ++size;
    return size;
  }

  /// the vector nearest to the guide, or the projection of the guide on the kernel
  void take(const Eigen_result& r, const Dirac_options& options, double bound,
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

  /// the sign of the guide, and a mean of |lambda|^2 of one; no rotation, for directions are fixed
  void normalize(Quaternion_vector<double>& lambda) const
  {
    const double sign =
        inner_product(m_directions.guide(), m_problem.areas(), lambda).w < 0 ? -1 : 1;
    components(lambda) *=
        sign * std::sqrt(m_problem.areas().sum() / m_problem.squared_norm(lambda));
  }

  double overlap(const Quaternion_vector<double>& a, const Quaternion_vector<double>& b) const
  {
    return std::abs(inner_product(a, m_problem.areas(), b).w) /
           std::sqrt(m_problem.squared_norm(a) * m_problem.squared_norm(b));
  }

  Problem& m_problem;
  const Directions& m_directions;
  Reduced_hermitian_solver m_solver;
};

}  // namespace Conformal_geometry_processing

#endif
