// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_EIGENPROBLEM_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_EIGENPROBLEM_TEMPLATES_H

#include <Conformal_geometry_processing/algebra/random_quaternions.h>
#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Stopwatch.h>
#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Conformal_geometry_processing/spin/Dirac_eigenproblem.h>

#include <Eigen/Core>

#include <cmath>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

template <class SolverTraits, class EigensolverTraits, class Surface>
Dirac_eigenproblem<SolverTraits, EigensolverTraits, Surface>::Dirac_eigenproblem(
    const Surface& mesh)
    : m_mesh(mesh), m_areas(vertex_areas(mesh)), m_X(vertex_graph(mesh))
{
  check("analysis", m_solver.analyze_with_positions(m_X.pattern(), mesh.positions()));
}

template <class SolverTraits, class EigensolverTraits, class Surface>
double Dirac_eigenproblem<SolverTraits, EigensolverTraits, Surface>::unit() const
{
  const double pi = std::acos(-1.);
  return 4 * pi / m_areas.sum();
}

template <class SolverTraits, class EigensolverTraits, class Surface>
void Dirac_eigenproblem<SolverTraits, EigensolverTraits, Surface>::set_potential(
    const Curvature_potential& rho, Dirac_solution::Seconds& seconds)
{
  assemble(rho, seconds);
  Stopwatch watch;
  Solver_status status = m_solver.factorize(m_X, 1e-3 * unit() * m_areas);
  if (status == Solver_status::not_positive_definite)
    status = m_solver.factorize(m_X, 1e-2 * unit() * m_areas);
  check("factorization", status);
  seconds.factorization += watch.lap();
}

template <class SolverTraits, class EigensolverTraits, class Surface>
void Dirac_eigenproblem<SolverTraits, EigensolverTraits, Surface>::set_potential(
    const Curvature_potential& rho, const Eigen::VectorXd& shift, Dirac_solution::Seconds& seconds)
{
  assemble(rho, seconds);
  Stopwatch watch;
  check("factorization", m_solver.factorize(m_X, shift));
  seconds.factorization += watch.lap();
}

template <class SolverTraits, class EigensolverTraits, class Surface>
void Dirac_eigenproblem<SolverTraits, EigensolverTraits, Surface>::assemble(
    const Curvature_potential& rho, Dirac_solution::Seconds& seconds)
{
  Stopwatch watch;
  assemble_dirac_energy(m_mesh, rho, m_X);
  seconds.assembly += watch.lap();
}

template <class SolverTraits, class EigensolverTraits, class Surface>
auto Dirac_eigenproblem<SolverTraits, EigensolverTraits, Surface>::solve(const Vectors& b) const
    -> Vectors
{
  Vectors x;
  check("solution", m_solver.solve(b, x));
  return x;
}

template <class SolverTraits, class EigensolverTraits, class Surface>
Eigensolver_result Dirac_eigenproblem<SolverTraits, EigensolverTraits, Surface>::smallest(
    Vectors start, int wanted, double tolerance, int max_iterations,
    const Go_further& go_further) const
{
  Eigensolver_options options;
  options.wanted = wanted;
  options.tolerance = tolerance;
  options.max_iterations = max_iterations;
  options.scale = std::sqrt(unit());
  return EigensolverTraits()(m_X, m_areas, m_solver, std::move(start), options, go_further);
}

template <class SolverTraits, class EigensolverTraits, class Surface>
auto Dirac_eigenproblem<SolverTraits, EigensolverTraits, Surface>::start(
    const Quaternion_vector<double>& guide, unsigned seed) const -> Vectors
{
  const Vectors b = block_operator(m_areas)(random_quaternions(guide.size(), 1, seed));
  Vectors x;
  check("solution", apply_inverse(m_solver, b, x));
  Vectors both(guide.size(), 2);
  both << guide, x;
  return both;
}

template <class SolverTraits, class EigensolverTraits, class Surface>
auto Dirac_eigenproblem<SolverTraits, EigensolverTraits, Surface>::with_rest(
    const Quaternion_vector<double>& v, const Quaternion_vector<double>& guide) const -> Vectors
{
  Vectors both(v.size(), 2);
  both << v, without(v, guide);
  return both;
}

template <class SolverTraits, class EigensolverTraits, class Surface>
auto Dirac_eigenproblem<SolverTraits, EigensolverTraits, Surface>::companion(
    const Quaternion_vector<double>& v, const Quaternion_vector<double>& image) const -> Vectors
{
  return inverse_beyond(v, image);
}

template <class SolverTraits, class EigensolverTraits, class Surface>
void Dirac_eigenproblem<SolverTraits, EigensolverTraits, Surface>::add_companion(
    const Quaternion_vector<double>& v, Vectors& companions) const
{
  const Eigen::Index k = companions.cols();
  Quaternion_vector<double> b = companions.col(k - 1);
  for (Eigen::Index i = 0; i < b.size(); ++i) b[i] *= m_areas[i];
  companions.conservativeResize(Eigen::NoChange, k + 1);
  companions.col(k) = inverse_beyond(v, b).col(0);
}

template <class SolverTraits, class EigensolverTraits, class Surface>
auto Dirac_eigenproblem<SolverTraits, EigensolverTraits, Surface>::with_lowest(
    const Quaternion_vector<double>& v, Vectors companions) const -> Vectors
{
  Ritz_panel space =
      make_panel(block_operator(m_X), block_operator(m_areas), std::move(companions));
  orthonormalize(space);
  Vectors both = v;
  if (space.size() == 0) return both;
  const auto ritz = hermitian_jacobi(gram_matrix(space.v, space.kv));
  both.conservativeResize(Eigen::NoChange, 2);
  both.col(1) = combination(space.v, Vectors(ritz.vectors.leftCols(1))).col(0);
  return both;
}

template <class SolverTraits, class EigensolverTraits, class Surface>
double Dirac_eigenproblem<SolverTraits, EigensolverTraits, Surface>::overlap(
    const Quaternion_vector<double>& a, const Quaternion_vector<double>& b) const
{
  return norm(inner_product(a, m_areas, b)) / std::sqrt(squared_norm(a) * squared_norm(b));
}

template <class SolverTraits, class EigensolverTraits, class Surface>
double Dirac_eigenproblem<SolverTraits, EigensolverTraits, Surface>::squared_norm(
    const Quaternion_vector<double>& a) const
{
  return inner_product(a, m_areas, a).w;
}

template <class SolverTraits, class EigensolverTraits, class Surface>
void Dirac_eigenproblem<SolverTraits, EigensolverTraits, Surface>::check(const char* step,
                                                                         Solver_status status)
{
  if (status != Solver_status::success)
    throw Solver_error("Dirac_equation", std::string(step) + " of X failed: " + to_string(status));
}

template <class SolverTraits, class EigensolverTraits, class Surface>
auto Dirac_eigenproblem<SolverTraits, EigensolverTraits, Surface>::inverse_beyond(
    const Quaternion_vector<double>& v, const Quaternion_vector<double>& b) const -> Vectors
{
  const Vectors image = b;
  Vectors u;
  check("solution", apply_inverse(m_solver, image, u));
  return without(v, u.col(0));
}

template <class SolverTraits, class EigensolverTraits, class Surface>
auto Dirac_eigenproblem<SolverTraits, EigensolverTraits, Surface>::without(
    const Quaternion_vector<double>& v, const Quaternion_vector<double>& u) const -> Vectors
{
  Vectors rest = u;
  const Quaternion<double> along = inner_product(v, m_areas, u) / squared_norm(v);
  add_multiple(rest.col(0), v, -along);
  return rest;
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class Dirac_eigenproblem<Default_solver_traits, Lobpcg_eigensolver_traits,
                                         Mesh_view>;
extern template class Dirac_eigenproblem<Default_solver_traits, Lobpcg_eigensolver_traits,
                                         Delaunay_view>;

}  // namespace Conformal_geometry_processing
#endif

#endif
