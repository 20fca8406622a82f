// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Spin_derivative.h>

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/spin/Spin_residual.h>
#include <Quaternionic_linear_algebra/dense/block_operators.h>
#include <Quaternionic_linear_algebra/krylov/conjugate_gradients.h>

#include <Eigen/Geometry>

#include <cmath>
#include <utility>

namespace Conformal_geometry_processing::internal {

/// calls use(face, c, vertex, gradient of the face's area with respect to the vertex)
template <class Use>
void for_each_area_gradient(const Mesh_view& mesh, const Points& f, const Points& normals, Use use)
{
  for (int i = 0; i < mesh.size_of_faces(); ++i) {
    const auto& v = mesh.corners(i);
    for (std::size_t c = 0; c < 3; ++c) {
      const Eigen::Vector3d opposite = f.col(v[(c + 2) % 3]) - f.col(v[(c + 1) % 3]);
      use(i, v[c], Eigen::Vector3d(normals.col(i).cross(opposite) / 2));
    }
  }
}

Placement_derivative::Placement_derivative(const Mesh_view& mesh, Points f)
    : m_mesh(mesh),
      m_arms(std::move(f)),
      m_area_gradient(Points::Zero(3, m_arms.cols())),
      m_areas(mesh.size_of_faces()),
      m_middle(3, mesh.size_of_faces()),
      m_normals(3, mesh.size_of_faces())
{
  for (int i = 0; i < mesh.size_of_faces(); ++i) {
    const auto& v = mesh.corners(i);
    const Eigen::Vector3d twice = mesh.double_area_vector(i, m_arms);
    m_areas[i] = twice.norm() / 2;
    m_normals.col(i) = stable_normalized(twice);
    m_middle.col(i) = (m_arms.col(v[0]) + m_arms.col(v[1]) + m_arms.col(v[2])) / 3;
  }
  const Eigen::Vector3d centroid = m_middle * m_areas / m_areas.sum();
  m_middle.colwise() -= centroid;
  m_arms.colwise() -= centroid;
  for_each_area_gradient(mesh, m_arms, m_normals, [this](int, int v, const Eigen::Vector3d& g) {
    m_area_gradient.col(v) += g;
  });
}

Points Placement_derivative::apply(const Points& df) const
{
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for_each_area_gradient(m_mesh, m_arms, m_normals, [&](int i, int v, const Eigen::Vector3d& g) {
    moment += g.dot(df.col(v)) * m_middle.col(i) + m_areas[i] / 3 * df.col(v);
  });
  const double growth = m_area_gradient.cwiseProduct(df).sum() / (2 * m_areas.sum());
  return (df - growth * m_arms).colwise() - moment / m_areas.sum();
}

Points Placement_derivative::apply_transpose(const Points& y) const
{
  const double area = m_areas.sum(), growth = y.cwiseProduct(m_arms).sum() / (2 * area);
  const Eigen::Vector3d force = y.rowwise().sum() / area;
  Points result = y - growth * m_area_gradient;
  for_each_area_gradient(m_mesh, m_arms, m_normals, [&](int i, int v, const Eigen::Vector3d& g) {
    result.col(v) -= m_middle.col(i).dot(force) * g + m_areas[i] / 3 * force;
  });
  return result;
}

Position_derivative::Position_derivative(const Dirac_system& system,
                                         const Poisson_reconstruction& reconstruction,
                                         const Mesh_view& measured,
                                         Quaternion_vector<double> lambda, Points f)
    : m_system(system),
      m_reconstruction(reconstruction),
      m_lambda(std::move(lambda)),
      m_placement(measured, std::move(f))
{
  if (system.is_closed())
    for (Eigen::Index i = 0; i < m_lambda.size(); ++i) m_mean += system.areas()[i] * m_lambda[i].w;
}

// The mean stays real by a right factor 1 + c with an imaginary c.
Points Position_derivative::apply(Quaternion_vector<double> dlambda) const
{
  if (m_mean != 0) {
    Quaternion<double> c;
    for (Eigen::Index i = 0; i < dlambda.size(); ++i)
      c -= m_system.areas()[i] / m_mean * dlambda[i];
    c.w = 0;
    for (Eigen::Index i = 0; i < dlambda.size(); ++i) dlambda[i] += m_lambda[i] * c;
  }
  return m_placement.apply(
      m_reconstruction.positions(edge_change(m_system.surface(), m_lambda, dlambda)));
}

Quaternion_vector<double> Position_derivative::apply_transpose(const Points& y) const
{
  Quaternion_vector<double> q =
      edge_gradient(m_system.surface(), m_lambda,
                    m_reconstruction.edge_gradient(m_placement.apply_transpose(y).transpose()));
  if (m_mean != 0) {
    Quaternion<double> turn = inner_product(m_lambda, q);
    turn.w = 0;
    for (Eigen::Index i = 0; i < q.size(); ++i) q[i] -= m_system.areas()[i] / m_mean * turn;
  }
  return q;
}

Spin_derivative::Spin_derivative(const Dirac_system& system, Curvature_potential potential,
                                 Quaternion_vector<double> lambda, double tolerance)
    : m_system(system),
      m_potential(std::move(potential)),
      m_lambda(std::move(lambda)),
      m_length(std::sqrt(system.squared_norm(m_lambda))),
      m_tolerance(tolerance)
{
  components(m_lambda) /= m_length;
  if (!is_eigenvector()) {
    m_diagonal = nearness_weight(system.surface()) * system.areas();
    return;
  }
  const double mu = inner_product(m_lambda, system.matrix() * m_lambda).w;
  m_diagonal = -mu * system.areas();
  if (!system.is_closed()) return;
  const Vectors form = apply_dirac_form(system.surface(), m_potential, m_lambda);
  m_gamma_gradient = form_gradient(system.surface(), m_potential.on, m_lambda) -
                     2 * apply_transpose_at_fixed_gamma(form).col(0);
}

auto Spin_derivative::apply(const Eigen::MatrixXd& changes) const -> Vectors
{
  Vectors result = apply_at_fixed_gamma(changes.rowwise() + gamma_change(changes));
  for (Quaternion<double>& q : result.reshaped()) q *= m_length;
  return result;
}

Eigen::RowVectorXd Spin_derivative::gamma_change(const Eigen::MatrixXd& changes) const
{
  if (m_gamma_gradient.size() == 0) return Eigen::RowVectorXd::Zero(changes.cols());
  return -(m_gamma_gradient.transpose() * changes) / m_gamma_gradient.sum();
}

Eigen::MatrixXd Spin_derivative::apply_transpose(const Vectors& q) const
{
  Eigen::MatrixXd result = m_length * apply_transpose_at_fixed_gamma(q);
  if (m_gamma_gradient.size() == 0) return result;
  const Eigen::RowVectorXd of_gamma = result.colwise().sum() / m_gamma_gradient.sum();
  return result - m_gamma_gradient * of_gamma;
}

auto Spin_derivative::apply_at_fixed_gamma(const Eigen::MatrixXd& changes) const -> Vectors
{
  return solve(energy_change(m_system.surface(), m_potential, m_lambda, changes));
}

Eigen::MatrixXd Spin_derivative::apply_transpose_at_fixed_gamma(const Vectors& q) const
{
  return energy_gradient(m_system.surface(), m_potential, m_lambda, solve(q));
}

auto Spin_derivative::solve(Vectors b) const -> Vectors
{
  b = m_system.projected(std::move(b));
  remove_gauge(b, true);
  const auto matrix = [this](const Vectors& x, Vectors& y) { apply_matrix(x, y); };
  const auto precondition = [this](const Vectors& r, Vectors& z) {
    z = m_system.precondition(r);
    remove_gauge(z, false);
  };
  Conjugate_gradients_options options;
  options.tolerance = m_tolerance;
  Vectors x;
  const auto result = conjugate_gradients(matrix, precondition, b, x, options);
  const double worst_error = 1e-3;  // of rounding, with slivers
  if (!result.converged && !(result.estimates.maxCoeff() <= worst_error))
    throw Solver_error("Spin_derivative", "the iterations do not converge");
  return x;
}

void Spin_derivative::apply_matrix(const Vectors& x, Vectors& y) const
{
  block_operator(m_system.matrix())(x, y);
  for (Eigen::Index k = 0; k < x.cols(); ++k)
    for (Eigen::Index i = 0; i < x.rows(); ++i) y(i, k) += m_diagonal[i] * x(i, k);
  y = m_system.projected(std::move(y));
}

void Spin_derivative::remove_gauge(Vectors& v, bool is_form) const
{
  if (!is_eigenvector()) return;
  const Eigen::VectorXd& areas = m_system.areas();
  for (Eigen::Index k = 0; k < v.cols(); ++k) {
    const Quaternion<double> share =
        reduced_to(m_system.coefficients(), is_form ? inner_product(m_lambda, v.col(k))
                                                    : inner_product(m_lambda, areas, v.col(k)));
    for (Eigen::Index i = 0; i < v.rows(); ++i)
      v(i, k) -= (is_form ? areas[i] : 1.) * (m_lambda[i] * share);
  }
}

}  // namespace Conformal_geometry_processing::internal
