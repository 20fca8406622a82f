// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_CLOSING_CONSTRAINTS_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_CLOSING_CONSTRAINTS_TEMPLATES_H

#include <Conformal_geometry_processing/flow/Closing_constraints.h>
#include <Conformal_geometry_processing/forms/tree_cotree.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>

#include <optional>

namespace Conformal_geometry_processing {

template <class SolverTraits, class EigensolverTraits>
Closing_constraints<SolverTraits, EigensolverTraits>::Closing_constraints(
    const Mesh_view& mesh, Equation& equation, std::optional<Exactness> version,
    Curvature_potential::On on)
    : m_mesh(mesh),
      m_equation(equation),
      m_version(version),
      m_on(on),
      m_generators(closed_generators(mesh)),
      m_functions(
          on == Curvature_potential::On::vertices ? mesh.size_of_vertices() : mesh.size_of_faces(),
          0)
{}

template <class SolverTraits, class EigensolverTraits>
void Closing_constraints<SolverTraits, EigensolverTraits>::update(
    const Grounded_solver<SolverTraits>& laplacian)
{
  if (m_generators.cols() == 0) return;
  m_basis = Hodge_decomposition<SolverTraits>(m_mesh, m_generators, laplacian).harmonic_basis();
  if (!m_version) return;
  m_functions = m_equation.is_closed() ? closed_functions() : bounded_functions();
}

template <class SolverTraits, class EigensolverTraits>
Constraint_basis Closing_constraints<SolverTraits, EigensolverTraits>::basis() const
{
  return internal::closing_basis(
      m_on == Curvature_potential::On::vertices ? vertex_areas(m_mesh) : face_areas(m_mesh),
      m_equation.is_self_adjoint(), m_functions);
}

template <class SolverTraits, class EigensolverTraits>
double Closing_constraints<SolverTraits, EigensolverTraits>::defect(
    const Eigen::MatrixX3d& edges) const
{
  if (m_generators.cols() == 0) return 0;
  return internal::period_defect(cotan_weights(m_mesh), m_basis, edges);
}

template <class SolverTraits, class EigensolverTraits>
Eigen::MatrixXd Closing_constraints<SolverTraits, EigensolverTraits>::closed_functions()
{
  if (m_inverse)
    m_inverse->update_geometry();
  else
    m_inverse.emplace(m_mesh, m_equation.problem().solver());
  return exactness_constraints(m_mesh, m_basis, *m_inverse, m_on, *m_version);
}

template <class SolverTraits, class EigensolverTraits>
Eigen::MatrixXd Closing_constraints<SolverTraits, EigensolverTraits>::bounded_functions()
{
  const auto respond = [&](const Block<Quaternion<double>>& c) { return m_equation.response(c); };
  return bounded_exactness_constraints(m_mesh, m_basis, respond, m_on);
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class Closing_constraints<Default_solver_traits, Lobpcg_eigensolver_traits>;

}  // namespace Conformal_geometry_processing
#endif

#endif
