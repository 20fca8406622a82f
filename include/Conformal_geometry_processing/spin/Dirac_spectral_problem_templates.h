// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_SPECTRAL_PROBLEM_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_DIRAC_SPECTRAL_PROBLEM_TEMPLATES_H

#include <Conformal_geometry_processing/algebra/random_quaternions.h>
#include <Conformal_geometry_processing/mesh/boundary_loops.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/spin/Dirac_spectral_problem.h>
#include <Conformal_geometry_processing/spin/Dirac_system_templates.h>
#include <Conformal_geometry_processing/spin/dirac_pencils.h>
#include <Conformal_geometry_processing/spin/rayleigh_ritz_of_dirac.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

template <class SolverTraits>
internal::Dirac_spectral_problem<SolverTraits>::Dirac_spectral_problem(
    const Mesh_view& mesh, const Boundary_condition& condition, const std::string& function)
    : m_function(function),
      m_frame(checked(mesh, condition, function).positions()),
      m_mesh(m_frame.to_frame(mesh.positions()), mesh.corners()),
      m_system(m_mesh, condition, function),
      m_rho(no_potential(m_mesh))
{}

template <class SolverTraits>
internal::Dirac_spectrum internal::Dirac_spectral_problem<SolverTraits>::find(
    const Curvature_potential& rho, int count, const internal::Dirac_spectrum_options& options,
    const Go_further& go_further)
{
  require_input(rho, count, options.shift);
  set_potential({rho.on, (rho.values.array() + options.shift).matrix() * m_frame.unit()});
  internal::Dirac_spectrum s;
  s.size_of_constants = static_cast<int>((std::min<Eigen::Index>)(count, m_constants.cols()));
  internal::Krylov_result r;
  r.converged = true;
  std::vector<Pair> pairs;
  if (count > s.size_of_constants) {
    const int wanted = count - s.size_of_constants;
    r = iterate(internal::pencil_of_form(m_system, m_rho, m_constants), wanted, options,
                go_further);
    pairs = with_those_at_the_shift(r, options);
    pairs.resize((std::min)(pairs.size(), static_cast<std::size_t>(wanted)));
  }
  s.restarts = r.restarts;
  s.converged = r.converged;
  s.cancelled = r.cancelled;
  fill(pairs, options.shift, s);
  return s;
}

template <class SolverTraits>
const Mesh_view& internal::Dirac_spectral_problem<SolverTraits>::checked(
    const Mesh_view& mesh, const Boundary_condition& condition, const std::string& function)
{
  require_surface(mesh, function);
  require_condition(mesh, condition, function);
  if (!boundary_loops(mesh).empty() && !condition.is_self_adjoint())
    throw Precondition_error(
        function,
        "a surface with boundary has a spectrum where directions orthogonal to its tangents are "
        "prescribed, such as the binormals; nothing, tangents and positions do not do");
  return mesh;
}

template <class SolverTraits>
void internal::Dirac_spectral_problem<SolverTraits>::require_input(const Curvature_potential& rho,
                                                                   int count, double shift) const
{
  const bool on_faces = rho.on == Curvature_potential::On::faces;
  const int size = on_faces ? m_mesh.size_of_faces() : m_mesh.size_of_vertices();
  if (rho.values.size() != size || !rho.values.allFinite() || !std::isfinite(shift))
    throw Precondition_error(m_function, "a finite shift and " + std::to_string(size) +
                                             " finite values of rho are needed");
  if (count < 1) throw Precondition_error(m_function, "no eigenvalue is asked for");
}

template <class SolverTraits>
internal::Krylov_result internal::Dirac_spectral_problem<SolverTraits>::iterate(
    const internal::Pencil& pencil, int wanted, const internal::Dirac_spectrum_options& options,
    const Go_further& go_further) const
{
  internal::Krylov_options krylov;
  krylov.wanted = wanted;
  krylov.tolerance = options.tolerance;
  krylov.max_restarts = options.max_restarts;
  const auto noise = [this, seed = options.random_seed](Eigen::Index columns) mutable {
    return internal::solve_beside(m_system, m_constants,
                                  block_operator(m_system.areas())(random_quaternions(
                                      m_system.areas().size(), columns, seed++)));
  };
  return krylov_schur(pencil, m_mesh.size_of_vertices(), noise, krylov, go_further);
}

template <class SolverTraits>
auto internal::Dirac_spectral_problem<SolverTraits>::pair(const Quaternion_vector<double>& v,
                                                          double residual) const -> Pair
{
  const internal::Dirac_forms forms = internal::forms_in_space(m_system, m_rho, v);
  const double form = forms.dirac(0, 0).w;
  return {form / forms.mass(0, 0).w, energy(v) / form, residual, v};
}

template <class SolverTraits>
auto internal::Dirac_spectral_problem<SolverTraits>::with_those_at_the_shift(
    const internal::Krylov_result& r, const internal::Dirac_spectrum_options& options) const
    -> std::vector<Pair>
{
  std::vector<Pair> pairs = at_the_shift(r, options);
  const std::size_t count = pairs.size();
  for (Eigen::Index k = 0; k < r.values.size(); ++k) {
    const Quaternion_vector<double> v = r.vectors.col(k);
    double share = 0;  // share of v in the span of these vectors
    for (std::size_t i = 0; i < count; ++i)
      share += std::pow(m_system.overlap(pairs[i].vector, v), 2);
    if (share < 0.5) pairs.push_back(pair(v, r.residuals[k]));
  }
  std::stable_sort(pairs.begin(), pairs.end());
  return pairs;
}

template <class SolverTraits>
auto internal::Dirac_spectral_problem<SolverTraits>::at_the_shift(
    const internal::Krylov_result& r, const internal::Dirac_spectrum_options& options) const
    -> std::vector<Pair>
{
  double nearest = std::numeric_limits<double>::infinity();
  for (double theta : r.values) nearest = (std::min)(nearest, std::abs(1 / theta));
  internal::Dirac_spectrum_options rough = options;
  rough.tolerance = (std::max)(1e-3, options.tolerance);
  const int most = static_cast<int>(r.values.size());
  int count = 0;
  for (int wanted = (std::min)(2, most);; wanted = (std::min)(2 * wanted, most)) {
    count = count_below(0.8 * nearest,
                        iterate(internal::pencil_of_masses(m_system, m_constants), wanted, rough));
    if (count < wanted || wanted == most) break;
  }
  std::vector<Pair> pairs;
  if (count == 0) return pairs;
  const internal::Krylov_result exact =
      iterate(internal::pencil_of_masses(m_system, m_constants), count, options);
  const Vectors separated = rayleigh_ritz_of_dirac(
      exact.vectors, internal::forms_in_space(m_system, m_rho, exact.vectors));
  for (Eigen::Index k = 0; k < separated.cols(); ++k)
    pairs.push_back(pair(separated.col(k), exact.residuals.maxCoeff()));
  return pairs;
}

template <class SolverTraits>
int internal::Dirac_spectral_problem<SolverTraits>::count_below(
    double bound, const internal::Krylov_result& standard) const
{
  int count = 0;
  for (Eigen::Index k = 0; k < standard.values.size(); ++k) {
    const Quaternion_vector<double> v = standard.vectors.col(k);
    count += energy(v) < bound * bound * m_system.squared_norm(v);
  }
  return count;
}

template <class SolverTraits>
double internal::Dirac_spectral_problem<SolverTraits>::energy(
    const Quaternion_vector<double>& v) const
{
  return inner_product(v, m_system.matrix() * v).w;
}

template <class SolverTraits>
void internal::Dirac_spectral_problem<SolverTraits>::set_potential(Curvature_potential rho)
{
  m_rho = std::move(rho);
  const double negligible = 1e-12 * std::sqrt(m_system.unit());
  const bool is_zero = m_rho.values.cwiseAbs().maxCoeff() <= negligible;
  m_constants =
      is_zero ? internal::constants_in_space(m_system) : Vectors(m_system.areas().size(), 0);
  internal::Dirac_evidence::Seconds seconds;
  m_system.set_potential(m_rho, seconds, 1e-9);
}

template <class SolverTraits>
void internal::Dirac_spectral_problem<SolverTraits>::fill(const std::vector<Pair>& pairs,
                                                          double shift,
                                                          internal::Dirac_spectrum& s) const
{
  const Eigen::Index constants = s.size_of_constants,
                     size = constants + static_cast<Eigen::Index>(pairs.size());
  s.eigenvalues = s.pencil_eigenvalues = Eigen::VectorXd::Constant(size, shift);
  s.residuals = Eigen::VectorXd::Zero(size);
  s.vectors.resize(m_mesh.size_of_vertices(), size);
  for (Eigen::Index k = 0; k < constants; ++k)
    s.vectors.col(k) = m_system.normalized(m_constants.col(k));
  Eigen::Index k = constants;
  for (const Pair& p : pairs) {
    s.eigenvalues[k] = shift + p.quotient / m_frame.unit();
    s.pencil_eigenvalues[k] = shift + p.of_pencil / m_frame.unit();
    s.residuals[k] = p.residual;
    s.vectors.col(k++) = m_system.normalized(p.vector);
  }
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class internal::Dirac_spectral_problem<Default_solver_traits>;

}  // namespace Conformal_geometry_processing
#endif

#endif
