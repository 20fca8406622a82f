// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_PENCIL_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_PENCIL_TEMPLATES_H

#include <Conformal_geometry_processing/algebra/random_quaternions.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>
#include <Conformal_geometry_processing/spin/Dirac_pencil.h>
#include <Conformal_geometry_processing/spin/constant_spins.h>
#include <Conformal_geometry_processing/spin/gauge.h>

#include <Eigen/Core>

#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

template <class SolverTraits>
Dirac_pencil<SolverTraits>::Dirac_pencil(const Mesh_view& mesh, const Boundary_condition& condition,
                                         const std::string& function)
    : m_function(function), m_mesh(mesh), m_areas(vertex_areas(mesh)), m_X(vertex_graph(mesh))
{
  check("analysis", m_solver.analyze_with_positions(m_X.pattern(), m_mesh.positions()));
  if (condition.kind != Boundary_condition::Kind::directions) return;
  m_directions = std::make_unique<Prescribed_directions<SolverTraits>>(
      m_mesh, condition, m_X.shared_pattern(), m_solver);
  check("analysis",
        m_reduced.analyze_with_positions(m_X.pattern(), basis().rows(), m_mesh.positions()));
}

template <class SolverTraits>
void Dirac_pencil<SolverTraits>::set_potential(Curvature_potential rho)
{
  m_rho = std::move(rho);
  const double negligible = 1e-12 * std::sqrt(unit());
  const bool is_zero = m_rho.values.cwiseAbs().maxCoeff() <= negligible;
  m_constants = is_zero ? find_constants() : Vectors(m_areas.size(), 0);
  factorize();
}

template <class SolverTraits>
Coefficients Dirac_pencil<SolverTraits>::coefficients() const
{
  return m_directions ? Coefficients::reals : Coefficients::quaternions;
}

template <class SolverTraits>
Pencil Dirac_pencil<SolverTraits>::of_form() const
{
  Pencil pencil = of_masses();
  pencil.K = [this](const Vectors& v) { return apply_form(v); };
  return pencil;
}

template <class SolverTraits>
Pencil Dirac_pencil<SolverTraits>::of_masses() const
{
  Pencil pencil;
  pencil.coefficients = coefficients();
  pencil.K = [this](const Vectors& v) { return projected(block_operator(m_areas)(v)); };
  pencil.N = [this](const Vectors& v) { return apply_energy(v); };
  pencil.solve = [this](const Vectors& b) { return solve(b); };
  return pencil;
}

template <class SolverTraits>
auto Dirac_pencil<SolverTraits>::noise(Eigen::Index columns, unsigned seed) const -> Vectors
{
  return solve(block_operator(m_areas)(random_quaternions(m_areas.size(), columns, seed)));
}

template <class SolverTraits>
double Dirac_pencil<SolverTraits>::squared_norm(const Quaternion_vector<double>& v) const
{
  return inner_product(v, m_areas, v).w;
}

template <class SolverTraits>
auto Dirac_pencil<SolverTraits>::products(const Vectors& a, const Vectors& b) const -> Vectors
{
  return gram_matrix(a, block_operator(m_areas)(b), coefficients());
}

template <class SolverTraits>
Dirac_forms Dirac_pencil<SolverTraits>::forms(const Vectors& v) const
{
  Dirac_forms forms = dirac_forms(m_mesh, m_rho, v);
  for (Vectors* form : {&forms.dirac, &forms.mass})
    for (Eigen::Index k = 0; k < form->size(); ++k)
      form->data()[k] = reduced_to(coefficients(), form->data()[k]);
  return forms;
}

template <class SolverTraits>
Quaternion_vector<double> Dirac_pencil<SolverTraits>::normalized(
    Quaternion_vector<double> lambda) const
{
  if (!m_directions)
    fix_gauge(lambda, m_areas);
  else
    components(lambda) *= std::sqrt(m_areas.sum() / squared_norm(lambda));
  return lambda;
}

template <class SolverTraits>
void Dirac_pencil<SolverTraits>::check(const char* step, Solver_status status) const
{
  if (status != Solver_status::success)
    throw Solver_error(m_function, std::string(step) + " of X failed: " + to_string(status));
}

template <class SolverTraits>
double Dirac_pencil<SolverTraits>::unit() const
{
  const double pi = std::acos(-1.);
  return 4 * pi / m_areas.sum();
}

template <class SolverTraits>
auto Dirac_pencil<SolverTraits>::find_constants() const -> Vectors
{
  Vector<Quaternion<double>> spins =
      Vector<Quaternion<double>>::Constant(1, Quaternion<double>{1, 0, 0, 0});
  if (m_directions) spins = constant_spins(basis());
  Vectors v(m_areas.size(), spins.size());
  for (Eigen::Index c = 0; c < v.cols(); ++c)
    v.col(c).setConstant(spins[c] / std::sqrt(m_areas.sum()));
  return v;
}

template <class SolverTraits>
void Dirac_pencil<SolverTraits>::factorize()
{
  assemble_dirac_energy(m_mesh, m_rho, m_X);
  Solver_status status = Solver_status::not_positive_definite;
  for (const double share : {1e-9, 1e-6, 1e-3}) {  // slivers need more than others
    if (status != Solver_status::not_positive_definite) break;
    m_regularization = share * unit();
    const Eigen::VectorXd shift = m_regularization * m_areas;
    status =
        m_directions ? m_reduced.factorize(m_X, shift, basis()) : m_solver.factorize(m_X, shift);
  }
  check("factorization", status);
}

template <class SolverTraits>
auto Dirac_pencil<SolverTraits>::apply_form(const Vectors& v) const -> Vectors
{
  Vectors w(v.rows(), v.cols());
  for (Eigen::Index c = 0; c < v.cols(); ++c) w.col(c) = apply_dirac_form(m_mesh, m_rho, v.col(c));
  return projected(std::move(w));
}

template <class SolverTraits>
auto Dirac_pencil<SolverTraits>::apply_energy(const Vectors& v) const -> Vectors
{
  Vectors w = block_operator(m_X)(v);
  for (Eigen::Index c = 0; c < v.cols(); ++c)
    for (Eigen::Index i = 0; i < v.rows(); ++i)
      w(i, c) += (m_regularization * m_areas[i]) * v(i, c);
  return projected(std::move(w));
}

template <class SolverTraits>
auto Dirac_pencil<SolverTraits>::solve(Vectors b) const -> Vectors
{
  // What is there of the constants is rounding, which the factor would blow up.
  const Vectors masses = block_operator(m_areas)(m_constants);
  add_combination(b, masses, Vectors(-gram_matrix(m_constants, b, coefficients())));
  Vectors x;
  check("solution", m_directions ? m_reduced.solve(b, x) : m_solver.solve(b, x));
  add_combination(x, m_constants, Vectors(-gram_matrix(masses, x, coefficients())));
  return x;
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class Dirac_pencil<Default_solver_traits>;

}  // namespace Conformal_geometry_processing
#endif

#endif
