// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Dirac_spectrum.h>

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/spin/dirac_pencils.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Conformal_geometry_processing {

bool internal::Dirac_spectrum::is_complete() const
{
  if (!converged || size() < wanted) return false;
  return ((eigenvalues.array() - shift).abs() <= complete_radius).all();
}

std::vector<internal::Multiple_eigenvalue> with_multiplicities(const Eigen::VectorXd& eigenvalues,
                                                               double resolution)
{
  Eigen::VectorXd sorted = eigenvalues;
  std::sort(sorted.begin(), sorted.end());
  std::vector<internal::Multiple_eigenvalue> groups;
  for (Eigen::Index i = 0; i < sorted.size(); ++i) {
    if (i == 0 || sorted[i] - sorted[i - 1] >= resolution) groups.push_back({0, 0});
    internal::Multiple_eigenvalue& group = groups.back();
    group.value += (sorted[i] - group.value) / ++group.multiplicity;
  }
  return groups;
}

internal::Dirac_spectral_problem::Dirac_spectral_problem(const Mesh_view& mesh,
                                                         const Boundary_condition& condition,
                                                         const std::string& function,
                                                         const Spin_solvers& solvers)
    : m_function(function),
      m_frame(checked(mesh, condition, function).positions()),
      m_mesh(m_frame.to_frame(mesh.positions()), mesh.corners()),
      m_system(m_mesh, condition, function, solvers),
      m_rho(no_potential(m_mesh))
{}

internal::Dirac_spectrum internal::Dirac_spectral_problem::find(
    const Curvature_potential& rho, int count, const internal::Dirac_spectrum_options& options,
    const Go_further& go_further)
{
  const internal::Thread_team team;
  m_visits.require_no_visit(m_function);
  require_input(rho, count, options.shift);
  set_potential({rho.on, (rho.values.array() + options.shift).matrix() * m_frame.unit()});
  internal::Dirac_spectrum s;
  s.shift = options.shift;
  s.wanted = count;
  s.converged = true;
  append_constants((std::min)(count, static_cast<int>(m_constants.cols())), s);
  if (count > s.size_of_constants) {
    const Go_further guarded = m_visits.guarded(go_further);
    search(count - s.size_of_constants, options, go_further ? guarded : go_further, s);
  }
  return s;
}

const Mesh_view& internal::Dirac_spectral_problem::checked(const Mesh_view& mesh,
                                                           const Boundary_condition& condition,
                                                           const std::string& function)
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

void internal::Dirac_spectral_problem::require_input(const Curvature_potential& rho, int count,
                                                     double shift) const
{
  const bool on_faces = rho.on == Curvature_potential::On::faces;
  const int size = on_faces ? m_mesh.size_of_faces() : m_mesh.size_of_vertices();
  if (rho.values.size() != size || !rho.values.allFinite() || !std::isfinite(shift))
    throw Precondition_error(m_function, "a finite shift and " + std::to_string(size) +
                                             " finite values of rho are needed");
  if (count < 1) throw Precondition_error(m_function, "no eigenvalue is asked for");
}

int internal::Dirac_spectral_problem::size_of_space() const
{
  const int all = m_system.directions() ? m_system.directions()->basis().rows().dimension()
                                        : m_mesh.size_of_vertices();
  return all - static_cast<int>(m_constants.cols());
}

void internal::Dirac_spectral_problem::search(int wanted,
                                              const internal::Dirac_spectrum_options& options,
                                              const Go_further& go_further,
                                              internal::Dirac_spectrum& s) const
{
  const int all = size_of_space(), most = (std::min)(all, largest_subspace_size(wanted));
  if (wanted > all)
    throw Precondition_error(m_function, std::to_string(wanted) +
                                             " eigenvalues besides the constants are wanted, of " +
                                             std::to_string(all));
  internal::Krylov_result square;
  internal::Spectral_pairs best;
  int size = (std::min)(most, first_subspace_size(wanted));
  for (bool is_last = false; !is_last;) {
    square = iterate(size, square, options, go_further);
    s.restarts += square.restarts;
    internal::Spectral_pairs found = pairs(square);
    is_last = !square.converged || size == most || found.is_limited_by_mesh ||
              is_window_complete(found, wanted);
    size = next_subspace_size(size, most, found, wanted);
    if (complete_radius(found, wanted) >= complete_radius(best, wanted)) best = std::move(found);
  }
  s.converged = square.converged;
  s.cancelled = square.cancelled;
  if (s.converged) s.complete_radius = complete_radius(best, wanted) / m_frame.unit();
  append(best, wanted, s);
}

internal::Krylov_result internal::Dirac_spectral_problem::iterate(
    int wanted, const internal::Krylov_result& known,
    const internal::Dirac_spectrum_options& options, const Go_further& go_further) const
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
  return krylov_schur(internal::pencil_of_masses(m_system, m_constants), m_mesh.size_of_vertices(),
                      noise, krylov, go_further, known);
}

internal::Spectral_pairs internal::Dirac_spectral_problem::pairs(
    const internal::Krylov_result& square) const
{
  internal::Signed_eigenvectors e =
      signed_eigenvectors(internal::pencil_of_form(m_system, m_rho, m_constants), square);
  const Eigen::Index size = e.vectors.cols();
  internal::Spectral_pairs p;
  p.quotients = p.energies = p.squared_images = p.of_pencil = Eigen::VectorXd(size);
  const Curvature_potential none = no_potential(m_mesh);
  for (Eigen::Index k = 0; k < size; ++k) {
    const Quaternion_vector<double> v = e.vectors.col(k);
    const internal::Dirac_forms forms = internal::forms_in_space(m_system, m_rho, v);
    const double form = forms.dirac(0, 0).w, energy = inner_product(v, m_system.matrix() * v).w;
    p.quotients[k] = form / forms.mass(0, 0).w;
    p.energies[k] = energy / m_system.squared_norm(v);
    p.squared_images[k] = std::pow(dirac_misfit(m_mesh, none, v), 2);
    p.of_pencil[k] = energy / form;
  }
  p.slow_energy = std::pow(2 * std::acos(-1.) / (20 * mean_edge_length(m_mesh)), 2);
  p.residuals = std::move(e.residuals);
  p.vectors = std::move(e.vectors);
  p.reach = square.values.size() < size_of_space() ? e.reach - m_system.shift()
                                                   : std::numeric_limits<double>::infinity();
  return resolved_nearest_first(p);
}

void internal::Dirac_spectral_problem::set_potential(Curvature_potential rho)
{
  m_rho = std::move(rho);
  const double negligible = 1e-12 * std::sqrt(m_system.unit());
  const bool is_zero = m_rho.values.cwiseAbs().maxCoeff() <= negligible;
  m_constants =
      is_zero ? internal::constants_in_space(m_system) : Vectors(m_system.areas().size(), 0);
  internal::Dirac_evidence::Seconds seconds;
  m_system.set_potential(m_rho, seconds);
}

void internal::Dirac_spectral_problem::append_constants(int count,
                                                        internal::Dirac_spectrum& s) const
{
  s.size_of_constants = count;
  s.eigenvalues = s.pencil_eigenvalues = Eigen::VectorXd::Constant(count, s.shift);
  s.residuals = Eigen::VectorXd::Zero(count);
  s.vectors.resize(m_mesh.size_of_vertices(), count);
  for (Eigen::Index k = 0; k < count; ++k)
    s.vectors.col(k) = m_system.normalized(m_constants.col(k));
}

void internal::Dirac_spectral_problem::append(const internal::Spectral_pairs& pairs, int count,
                                              internal::Dirac_spectrum& s) const
{
  const Eigen::Index first = s.size(), size = (std::min<Eigen::Index>)(count, pairs.size());
  for (Eigen::VectorXd* values : {&s.eigenvalues, &s.pencil_eigenvalues, &s.residuals})
    values->conservativeResize(first + size);
  s.vectors.conservativeResize(Eigen::NoChange, first + size);
  s.eigenvalues.tail(size) = s.shift + pairs.quotients.head(size).array() / m_frame.unit();
  s.pencil_eigenvalues.tail(size) = s.shift + pairs.of_pencil.head(size).array() / m_frame.unit();
  s.residuals.tail(size) = pairs.residuals.head(size);
  for (Eigen::Index k = 0; k < size; ++k)
    s.vectors.col(first + k) = m_system.normalized(pairs.vectors.col(k));
}

}  // namespace Conformal_geometry_processing
