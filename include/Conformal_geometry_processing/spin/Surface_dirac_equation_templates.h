// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_SURFACE_DIRAC_EQUATION_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_SURFACE_DIRAC_EQUATION_TEMPLATES_H

#include <Conformal_geometry_processing/mesh/Delaunay_view.h>
#include <Conformal_geometry_processing/mesh/boundary_loops.h>
#include <Conformal_geometry_processing/spin/Surface_dirac_equation.h>
#include <Conformal_geometry_processing/spin/free_boundary.h>

#include <Eigen/Core>

#include <memory>
#include <string>

namespace Conformal_geometry_processing {

template <class SolverTraits, class EigensolverTraits, class Surface>
Surface_dirac_equation<SolverTraits, EigensolverTraits, Surface>::Surface_dirac_equation(
    const Surface& mesh, const Boundary_condition& condition, const std::string& function)
    : m_is_closed(boundary_loops(mesh).empty()), m_kind(condition.kind), m_closed(mesh)
{
  if (m_kind == Boundary_condition::Kind::directions) {
    m_is_self_adjoint = condition.is_self_adjoint();
    m_directions = std::make_unique<Directions>(
        mesh, condition, problem().matrix().shared_pattern(), problem().solver());
    m_reduced = std::make_unique<Reduced>(m_closed.problem(), *m_directions);
  }
  if (m_kind == Boundary_condition::Kind::positions)
    m_positions = std::make_unique<Prescribed_positions<SolverTraits, Problem>>(
        m_closed.problem(), condition, function);
}

template <class SolverTraits, class EigensolverTraits, class Surface>
void Surface_dirac_equation<SolverTraits, EigensolverTraits, Surface>::update_geometry()
{
  m_closed.update_geometry();
  if (m_directions) m_directions->update_geometry();
}

template <class SolverTraits, class EigensolverTraits, class Surface>
Block<Quaternion<double>>
Surface_dirac_equation<SolverTraits, EigensolverTraits, Surface>::response(
    const Block<Quaternion<double>>& c)
{
  return m_reduced ? m_reduced->response(c) : free_response(m_closed.problem(), c);
}

template <class SolverTraits, class EigensolverTraits, class Surface>
void Surface_dirac_equation<SolverTraits, EigensolverTraits, Surface>::release()
{
  m_closed.release();
  if (m_reduced) m_reduced->release();
}

template <class SolverTraits, class EigensolverTraits, class Surface>
Dirac_solution Surface_dirac_equation<SolverTraits, EigensolverTraits, Surface>::solve(
    const Curvature_potential& rho, const Dirac_options& options, const Go_further& go_further)
{
  if (m_is_closed) return m_closed.solve(rho, options, go_further);
  if (options.problem == Eigenproblem::generalized)
    throw Precondition_error("Dirac_equation",
                             "the generalized problem is for closed surfaces only");
  Dirac_solution s;
  if (m_reduced)
    m_reduced->solve(rho, m_is_self_adjoint, options, s, go_further);
  else if (m_positions)
    m_positions->solve(rho, s);
  else
    solve_with_free_boundary(m_closed.problem(), rho, s);
  if (!m_reduced) {
    const Quaternion_vector<double> one =
        Quaternion_vector<double>::Constant(problem().areas().size(), {1, 0, 0, 0});
    s.overlap = problem().overlap(s.lambda, one);
  }
  return s;
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class Surface_dirac_equation<Default_solver_traits, Lobpcg_eigensolver_traits,
                                             Mesh_view>;
extern template class Surface_dirac_equation<Default_solver_traits, Lobpcg_eigensolver_traits,
                                             Delaunay_view>;

}  // namespace Conformal_geometry_processing
#endif

#endif
