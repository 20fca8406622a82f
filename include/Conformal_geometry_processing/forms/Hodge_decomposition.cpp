// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>

#include <Conformal_geometry_processing/forms/tree_cotree.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

namespace Conformal_geometry_processing {

namespace internal {

Harmonic_part::Harmonic_part(const Surface_ref& surface, Eigen::VectorXd w,
                             Eigen::SparseMatrix<double> generators, Eigen::MatrixXd combinations,
                             Eigen::MatrixXd potentials)
    : m_surface(surface),
      m_weights(std::move(w)),
      m_generators(std::move(generators)),
      m_combinations(std::move(combinations)),
      m_potentials(std::move(potentials))
{}

/// A^T b for few columns b. Faster than a product of matrices, which would copy A.
Eigen::MatrixXd products_of_columns(const Eigen::MatrixXd& A, const Eigen::MatrixXd& b)
{
  Eigen::MatrixXd products(A.cols(), b.cols());
  for (Eigen::Index i = 0; i < A.cols(); ++i)
    for (Eigen::Index k = 0; k < b.cols(); ++k) products(i, k) = A.col(i).dot(b.col(k));
  return products;
}

/// A c, likewise
Eigen::MatrixXd sums_of_columns(const Eigen::MatrixXd& A, const Eigen::MatrixXd& c)
{
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(A.rows(), c.cols());
  for (Eigen::Index i = 0; i < A.cols(); ++i)
    for (Eigen::Index k = 0; k < c.cols(); ++k) sums.col(k) += c(i, k) * A.col(i);
  return sums;
}

Eigen::MatrixXd Harmonic_part::coefficients(const Eigen::MatrixXd& alpha) const
{
  const Eigen::MatrixXd weighted = m_weights.asDiagonal() * alpha;
  const Eigen::MatrixXd crossings = m_generators.transpose() * weighted;
  return m_combinations.transpose() * crossings -
         products_of_columns(m_potentials, codifferential(m_surface, m_weights, alpha));
}

Eigen::MatrixXd Harmonic_part::combinations(const Eigen::MatrixXd& c) const
{
  const Eigen::MatrixXd of_generators = m_combinations * c;
  return m_generators * of_generators - differential(m_surface, sums_of_columns(m_potentials, c));
}

}  // namespace internal

Hodge_decomposition::Hodge_decomposition(const Mesh_view& mesh, const std::string& function,
                                         const Spin_solvers& solvers)
    : Hodge_decomposition(Checked_mesh(mesh, function), solvers)
{}

Hodge_decomposition::Hodge_decomposition(const Surface_ref& surface, Eigen::MatrixXd generators,
                                         const internal::Grounded_solver& laplacian,
                                         const internal::Harmonic_part* start)
    : Hodge_decomposition(surface, std::move(generators), not_owned(laplacian), start)
{}

internal::Hodge_parts Hodge_decomposition::decompose(const Eigen::MatrixXd& omega) const
{
  internal::Hodge_parts parts;
  parts.potential = potential(omega);
  parts.exact = differential(m_surface, parts.potential);
  const Eigen::MatrixXd rest = omega - parts.exact;
  parts.harmonic = m_part->combinations(m_part->coefficients(rest));
  parts.coexact = rest - parts.harmonic;
  return parts;
}

Hodge_decomposition::Checked_mesh::Checked_mesh(const Mesh_view& mesh_, const std::string& function)
    : mesh(mesh_)
{
  require_surface(mesh, function);
}

Hodge_decomposition::Hodge_decomposition(const Checked_mesh& c, const Spin_solvers& solvers)
    : Hodge_decomposition(c.mesh, closed_generators(c.mesh), factored(c.mesh, solvers), nullptr)
{}

Hodge_decomposition::Hodge_decomposition(const Surface_ref& surface, Eigen::MatrixXd generators,
                                         Laplacian laplacian, const internal::Harmonic_part* start)
    : m_surface(surface), m_weights(cotan_weights(surface)), m_laplacian(std::move(laplacian))
{
  Eigen::SparseMatrix<double> crossings = generators.sparseView();
  Eigen::MatrixXd& forms = m_basis.one_forms = std::move(generators);
  Eigen::MatrixXd T = Eigen::MatrixXd::Identity(forms.cols(), forms.cols());
  Eigen::MatrixXd u = Eigen::MatrixXd::Zero(surface.size_of_vertices(), forms.cols());
  const auto combine = [&] { forms = crossings * T - differential(surface, u); };
  const auto remove_exact = [&] {
    u += internal::remove_exact_parts(surface, m_weights, *m_laplacian, forms);
  };
  if (start) {
    T = start->generator_combinations();
    u = start->potentials();
    combine();
  }
  remove_exact();
  const Eigen::MatrixXd change = internal::orthonormalize_forms(surface, forms);
  T *= change;
  u *= change;
  if (!start) {  // removes the errors in the exact part, which are large for generators
    combine();
    remove_exact();
  }
  m_part.emplace(surface, m_weights, std::move(crossings), std::move(T), std::move(u));
  for (Eigen::Index i = 0; i < forms.cols(); ++i)
    m_basis.fields.push_back(tangent_field(surface, forms.col(i)));
}

auto Hodge_decomposition::factored(const Mesh_view& mesh, const Spin_solvers& solvers) -> Laplacian
{
  const auto pattern = vertex_graph(mesh);
  const auto solver = std::make_shared<internal::Grounded_solver>(pattern, solvers);
  solver->factorize(cotan_laplacian(mesh, pattern));
  return solver;
}

auto Hodge_decomposition::not_owned(const internal::Grounded_solver& laplacian) -> Laplacian
{
  return {std::shared_ptr<const void>(), &laplacian};
}

Eigen::MatrixXd Hodge_decomposition::potential(const Eigen::MatrixXd& omega) const
{
  return m_laplacian->solve(codifferential(m_surface, m_weights, omega));
}

}  // namespace Conformal_geometry_processing
