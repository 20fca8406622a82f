// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_MOVING_DELAUNAY_VIEW_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_MOVING_DELAUNAY_VIEW_TEMPLATES_H

#include <Conformal_geometry_processing/flow/Moving_delaunay_view.h>
#include <Conformal_geometry_processing/forms/delaunay_exactness.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <Eigen/Core>

#include <type_traits>

namespace Conformal_geometry_processing {

template <class SolverTraits, class EigensolverTraits>
Moving_delaunay_view<SolverTraits, EigensolverTraits>::Moving_delaunay_view(
    Transformation& transformation, const Mesh_view& mesh, Exactness, Curvature_potential::On on)
    : m_transformation(transformation), m_on(on)
{
  move_to(mesh.positions());
}

template <class SolverTraits, class EigensolverTraits>
void Moving_delaunay_view<SolverTraits, EigensolverTraits>::update()
{
  const Delaunay_view& mesh = m_transformation.view();
  m_basis = harmonic_basis(mesh, m_transformation.reconstruction().solver());
  auto& equation = m_transformation.dirac_equation();
  if (equation.is_closed()) {
    auto& problem = equation.problem();
    using Solver = typename std::decay_t<decltype(problem)>::Solver;
    Dirac_solution::Seconds seconds;
    problem.set_potential(no_potential(mesh), seconds);
    const Dirac_energy_inverse<Solver> inverse(problem.matrix(), problem.areas(), problem.solver());
    m_functions = exactness_constraints(mesh, m_basis, inverse, m_on);
  } else {
    const auto respond = [&](const Block<Quaternion<double>>& c) { return equation.response(c); };
    m_functions = bounded_exactness_constraints(mesh, m_basis, respond, m_on);
  }
}

template <class SolverTraits, class EigensolverTraits>
Constraint_basis Moving_delaunay_view<SolverTraits, EigensolverTraits>::basis() const
{
  return internal::closing_basis(curvature_areas(m_transformation.view(), m_on),
                                 m_transformation.dirac_equation().is_self_adjoint(), m_functions);
}

template <class SolverTraits, class EigensolverTraits>
double Moving_delaunay_view<SolverTraits, EigensolverTraits>::defect(
    const Quaternion_vector<double>& lambda) const
{
  const Delaunay_view& mesh = m_transformation.view();
  return internal::period_defect(mesh.cotan_weights(), m_basis, transformed_edges(mesh, lambda));
}

template <class SolverTraits, class EigensolverTraits>
void Moving_delaunay_view<SolverTraits, EigensolverTraits>::move_to(const Points& positions)
{
  m_positions = positions;
  m_areas = m_transformation.unit() * m_transformation.unit() *
            curvature_areas(m_transformation.view(), m_on);
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class Moving_delaunay_view<Default_solver_traits, Lobpcg_eigensolver_traits>;

}  // namespace Conformal_geometry_processing
#endif

#endif
