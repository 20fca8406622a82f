// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FORMS_HODGE_DECOMPOSITION_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_FORMS_HODGE_DECOMPOSITION_TEMPLATES_H

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

template <class SolverTraits>
Hodge_decomposition<SolverTraits>::Hodge_decomposition(const Mesh_view& mesh,
                                                       const std::string& function)
    : Hodge_decomposition(Checked_mesh(mesh, function))
{}

template <class SolverTraits>
Hodge_decomposition<SolverTraits>::Hodge_decomposition(
    const Surface_ref& surface, Eigen::MatrixXd generators,
    const internal::Grounded_solver<SolverTraits>& laplacian)
    : Hodge_decomposition(surface, std::move(generators), not_owned(laplacian))
{}

template <class SolverTraits>
internal::Hodge_parts Hodge_decomposition<SolverTraits>::decompose(
    const Eigen::MatrixXd& omega) const
{
  internal::Hodge_parts parts;
  parts.potential = potential(omega);
  parts.exact = differential(m_surface, parts.potential);
  const Eigen::MatrixXd rest = omega - parts.exact;
  parts.harmonic = m_basis.one_forms * m_basis.coefficients(m_weights, rest);
  parts.coexact = rest - parts.harmonic;
  return parts;
}

template <class SolverTraits>
Hodge_decomposition<SolverTraits>::Checked_mesh::Checked_mesh(const Mesh_view& mesh_,
                                                              const std::string& function)
    : mesh(mesh_)
{
  require_surface(mesh, function);
}

template <class SolverTraits>
Hodge_decomposition<SolverTraits>::Hodge_decomposition(const Checked_mesh& c)
    : Hodge_decomposition(c.mesh, closed_generators(c.mesh), factored(c.mesh))
{}

template <class SolverTraits>
Hodge_decomposition<SolverTraits>::Hodge_decomposition(const Surface_ref& surface,
                                                       Eigen::MatrixXd generators,
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

template <class SolverTraits>
auto Hodge_decomposition<SolverTraits>::factored(const Mesh_view& mesh) -> Laplacian
{
  const auto pattern = vertex_graph(mesh);
  const auto solver = std::make_shared<internal::Grounded_solver<SolverTraits>>(pattern);
  solver->factorize(cotan_laplacian(mesh, pattern));
  return solver;
}

template <class SolverTraits>
auto Hodge_decomposition<SolverTraits>::not_owned(
    const internal::Grounded_solver<SolverTraits>& laplacian) -> Laplacian
{
  return {std::shared_ptr<const void>(), &laplacian};
}

template <class SolverTraits>
Eigen::MatrixXd Hodge_decomposition<SolverTraits>::potential(const Eigen::MatrixXd& omega) const
{
  return m_laplacian->solve(codifferential(m_surface, m_weights, omega));
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class Hodge_decomposition<Default_solver_traits>;

}  // namespace Conformal_geometry_processing
#endif

#endif
