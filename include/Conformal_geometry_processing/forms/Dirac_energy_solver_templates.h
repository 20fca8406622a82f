// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FORMS_DIRAC_ENERGY_SOLVER_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_FORMS_DIRAC_ENERGY_SOLVER_TEMPLATES_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/forms/Dirac_energy_solver.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>

#include <cmath>
#include <string>

namespace Conformal_geometry_processing {

template <class SolverTraits>
Dirac_energy_solver<SolverTraits>::Dirac_energy_solver(const Mesh_view& mesh)
    : m_mesh(mesh), m_X(vertex_graph(mesh))
{
  check("analysis", m_solver.analyze_with_positions(m_X.pattern(), mesh.positions()));
  update_geometry();
}

template <class SolverTraits>
void Dirac_energy_solver<SolverTraits>::update_geometry()
{
  const double pi = std::acos(-1.);
  m_areas = vertex_areas(m_mesh);
  assemble_dirac_energy(m_mesh, no_potential(m_mesh), m_X);
  const double unit = 4 * pi / m_areas.sum();  // the size of the low eigenvalues
  Solver_status status = m_solver.factorize(m_X, 1e-5 * unit * m_areas);
  if (status == Solver_status::not_positive_definite)  // to rounding, where there are slivers
    status = m_solver.factorize(m_X, 1e-2 * unit * m_areas);
  check("factorization", status);
}

template <class SolverTraits>
Block<Quaternion<double>> Dirac_energy_solver<SolverTraits>::operator()(
    const Block<Quaternion<double>>& c) const
{
  return Dirac_energy_inverse<Solver>(m_X, m_areas, m_solver)(c);
}

template <class SolverTraits>
void Dirac_energy_solver<SolverTraits>::check(const char* step, Solver_status status)
{
  if (status != Solver_status::success)
    throw Solver_error("Dirac_energy_solver",
                       std::string(step) + " of X failed: " + to_string(status));
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class Dirac_energy_solver<Default_solver_traits>;

}  // namespace Conformal_geometry_processing
#endif

#endif
