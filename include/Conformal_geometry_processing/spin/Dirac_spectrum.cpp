// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Dirac_spectrum.h>

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/spin/solve_dirac_equation.h>
#include <Quaternionic_linear_algebra/dense/hermitian_eigen_decomposition.h>
#include <Quaternionic_linear_algebra/krylov/Krylov_space.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace Conformal_geometry_processing {

double internal::squared_error(const internal::Spectral_pairs& pairs, Eigen::Index count)
{
  const Eigen::Index n = (std::min)(count, pairs.size());
  const auto errors = pairs.energies.head(n).array() - pairs.quotients.head(n).array().square();
  return n == 0 ? 0. : (std::max)(errors.maxCoeff(), 0.);
}

double internal::needed_reach(const internal::Spectral_pairs& pairs, Eigen::Index count)
{
  const double last = pairs.quotients[count - 1];
  return last * last + 2 * squared_error(pairs, count);
}

double internal::complete_radius(const internal::Spectral_pairs& pairs, Eigen::Index count)
{
  Eigen::Index sure = 0;
  while (sure < (std::min)(count, pairs.size()) && is_window_complete(pairs, sure + 1)) ++sure;
  if (sure == 0) return 0;
  const double radius = std::sqrt(pairs.reach - 2 * squared_error(pairs, sure));
  return sure < pairs.size() ? (std::min)(radius, std::abs(pairs.quotients[sure])) : radius;
}

bool internal::is_window_complete(const internal::Spectral_pairs& pairs, Eigen::Index count)
{
  return count <= pairs.size() && needed_reach(pairs, count) <= pairs.reach;
}

internal::Spectral_pairs internal::resolved_nearest_first(const internal::Spectral_pairs& pairs)
{
  const Eigen::ArrayXd errors = pairs.energies.array() - pairs.quotients.array().square();
  double reach = pairs.reach;
  std::vector<Eigen::Index> order;
  for (Eigen::Index k = 0; k < pairs.size(); ++k)
    if (2 * std::abs(errors[k]) <= pairs.squared_images[k] ||
        pairs.squared_images[k] <= pairs.slow_energy)
      order.push_back(k);
    else
      reach = (std::min)(reach, pairs.energies[k]);
  std::stable_sort(order.begin(), order.end(), [&](Eigen::Index i, Eigen::Index j) {
    return std::abs(pairs.quotients[i]) < std::abs(pairs.quotients[j]);
  });
  return {pairs.quotients(order),
          pairs.energies(order),
          pairs.squared_images(order),
          pairs.of_pencil(order),
          pairs.residuals(order),
          pairs.vectors(Eigen::indexing::all, order),
          reach,
          pairs.slow_energy,
          reach < pairs.reach};
}

int internal::first_subspace_size(int count)
{
  return count + 2 * static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count)))) + 2;
}

int internal::next_subspace_size(int size, int most, const internal::Spectral_pairs& pairs,
                                 int count)
{
  const bool is_estimate = count <= pairs.size() && pairs.reach > 0;
  const double needed = is_estimate ? needed_reach(pairs, count) / pairs.reach : 2;
  const double growth = std::clamp(1.1 * needed, 1.25, 2.);
  return (std::min)(most, static_cast<int>(std::ceil(size * growth)));
}

int internal::largest_subspace_size(int count)
{
  return count + 128;
}

namespace internal {

/// of |N^-1 K v|^2, where |v| = 1 by M: mixtures lose nearly 1, all others some thousandths even on
/// coarse meshes
inline constexpr double lost_by_mixtures = 0.1;

/// A^H diag(d) A
Block<Quaternion<double>> congruent(const Block<Quaternion<double>>& A, const Vector<double>& d)
{
  Block<Quaternion<double>> scaled = A;
  for (Eigen::Index j = 0; j < A.cols(); ++j)
    for (Eigen::Index i = 0; i < A.rows(); ++i) scaled(i, j) *= d[i];
  return gram_matrix(A, scaled);
}

/// the eigenvectors of M x = theta N x, M-orthonormal instead of N-orthonormal
Block<Quaternion<double>> normalized_by_mass(const Krylov_result& square)
{
  Block<Quaternion<double>> v = square.vectors;
  for (Eigen::Index j = 0; j < v.cols(); ++j) scale_column(v, j, 1 / std::sqrt(square.values[j]));
  return v;
}

Vector<double> combined_residuals(const Block<Quaternion<double>>& coefficients,
                                  const Vector<double>& residuals)
{
  Vector<double> norms = Vector<double>::Zero(coefficients.cols());
  for (Eigen::Index j = 0; j < norms.size(); ++j)
    for (Eigen::Index i = 0; i < residuals.size(); ++i)
      norms[j] += squared_norm(coefficients(i, j)) * residuals[i] * residuals[i];
  return norms.cwiseSqrt();
}

/// K and the losses |N^-1 K v|^2 - |component of N^-1 K v in the span|^2, in a basis
struct Signed_projection {
  Block<Quaternion<double>> form, losses;
};

Signed_projection signed_projection(const Pencil& pencil, const Row_major_multivector& basis,
                                    const Block<Quaternion<double>>& v, const Vector<double>& theta)
{
  const Block<Quaternion<double>> Kv = pencil.K(v);
  Row_major_multivector images(v.rows(), v.cols());
  images.append(Kv);
  Signed_projection p{basis.gram(Kv, pencil.coefficients),
                      images.gram(pencil.solve(Kv), pencil.coefficients)};
  p.losses -= congruent(p.form, theta);
  return p;
}

/// the coefficients of the vectors that lose nothing, and those of the others
std::array<Block<Quaternion<double>>, 2> split_by_losses(const Block<Quaternion<double>>& losses)
{
  const auto pairs = hermitian_eigen_decomposition(losses);
  const Eigen::Index kept = (pairs.values.array() < lost_by_mixtures).count();
  return {pairs.vectors.leftCols(kept), pairs.vectors.rightCols(pairs.values.size() - kept)};
}

/// the least Rayleigh quotient of diag(values)
double least_value(const Block<Quaternion<double>>& vectors, const Vector<double>& values)
{
  if (vectors.cols() == 0) return std::numeric_limits<double>::infinity();
  return hermitian_eigen_decomposition(congruent(vectors, values)).values[0];
}

/// \brief of sqrt(mu_i mu_j), which bounds |<v_i, K v_j>|: what N has mixed exceeds this share,
/// also where discretisation errors tell the squares of s + g and s - g apart by a large factor.
/// The error of K between vectors that N has not mixed is far below it.
inline constexpr double coupling_of_mixtures = 0.25;

bool may_be_mixed(double mu, double other, const Quaternion<double>& coupling)
{
  const bool are_close = mu <= 2 * other && other <= 2 * mu;
  return are_close || norm(coupling) > coupling_of_mixtures * std::sqrt(mu * other);
}

/// \brief S without the entries between vectors that N has not mixed: equal quotients of some that
/// the mesh resolves and others that it does not would.
Block<Quaternion<double>> between_mixtures(Block<Quaternion<double>> S, const Vector<double>& mu)
{
  for (Eigen::Index j = 0; j < S.cols(); ++j)
    for (Eigen::Index i = 0; i < S.rows(); ++i)
      if (!may_be_mixed(mu[i], mu[j], S(i, j))) S(i, j) = {};
  return S;
}

}  // namespace internal

internal::Signed_eigenvectors signed_eigenvectors(const internal::Pencil& form,
                                                  const internal::Krylov_result& square)
{
  using Vectors = Block<Quaternion<double>>;
  const Vectors v = internal::normalized_by_mass(square);
  internal::Row_major_multivector basis(v.rows(), v.cols());
  basis.append(v);
  const auto projection = internal::signed_projection(form, basis, v, square.values);
  const auto [pure, mixtures] = internal::split_by_losses(projection.losses);
  const Vector<double> mu = square.values.cwiseInverse();
  const Vectors S = internal::between_mixtures(projection.form, mu);
  const auto ritz = hermitian_eigen_decomposition(gram_matrix(pure, combination(S, pure)));
  const Vectors coefficients = combination(pure, ritz.vectors);
  return {basis.combination(coefficients),
          internal::combined_residuals(coefficients, square.residuals),
          (std::min)(mu.maxCoeff(), internal::least_value(mixtures, mu))};
}

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
