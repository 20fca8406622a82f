// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/forms/Hodge_decomposition.h>

#include <Conformal_geometry_processing/forms/tangent_field.h>
#include <Conformal_geometry_processing/forms/tree_cotree.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <Eigen/Core>

#include <memory>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

Hodge_decomposition::Hodge_decomposition(const Mesh_view& mesh, const std::string& function,
                                         const Spin_solvers& solvers)
    : Hodge_decomposition(Checked_mesh(mesh, function), solvers)
{}

Hodge_decomposition::Hodge_decomposition(const Surface_ref& surface, Eigen::MatrixXd generators,
                                         const internal::Grounded_solver& laplacian)
    : Hodge_decomposition(surface, std::move(generators), not_owned(laplacian))
{}

internal::Hodge_parts Hodge_decomposition::decompose(const Eigen::MatrixXd& omega) const
{
  internal::Hodge_parts parts;
  parts.potential = potential(omega);
  parts.exact = differential(m_surface, parts.potential);
  const Eigen::MatrixXd rest = omega - parts.exact;
  parts.harmonic = m_basis.one_forms * m_basis.coefficients(m_weights, rest);
  parts.coexact = rest - parts.harmonic;
  return parts;
}

Hodge_decomposition::Checked_mesh::Checked_mesh(const Mesh_view& mesh_, const std::string& function)
    : mesh(mesh_)
{
  require_surface(mesh, function);
}

Hodge_decomposition::Hodge_decomposition(const Checked_mesh& c, const Spin_solvers& solvers)
    : Hodge_decomposition(c.mesh, closed_generators(c.mesh), factored(c.mesh, solvers))
{}

Hodge_decomposition::Hodge_decomposition(const Surface_ref& surface, Eigen::MatrixXd generators,
                                         Laplacian laplacian)
    : m_surface(surface), m_weights(cotan_weights(surface)), m_laplacian(std::move(laplacian))
{
  Eigen::MatrixXd& forms = m_basis.one_forms = std::move(generators);
  internal::remove_exact_parts(surface, m_weights, *m_laplacian, forms);
  internal::orthonormalize_forms(surface, forms);
  // Removes the solver's error in the exact part, which is large for generators.
  internal::remove_exact_parts(surface, m_weights, *m_laplacian, forms);
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
