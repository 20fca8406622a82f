// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_MOVING_MESH_TEMPLATES_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_MOVING_MESH_TEMPLATES_H

#include <Conformal_geometry_processing/flow/Moving_mesh.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/transformed_edges.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

template <class SolverTraits, class EigensolverTraits>
Moving_mesh<SolverTraits, EigensolverTraits>::Moving_mesh(Transformation& transformation,
                                                          const Mesh_view& mesh,
                                                          Exactness exactness,
                                                          Curvature_potential::On on)
    : m_transformation(transformation),
      m_on(on),
      m_mesh(mesh),
      m_closing(m_mesh, transformation.dirac_equation(), exactness, on)
{}

template <class SolverTraits, class EigensolverTraits>
double Moving_mesh<SolverTraits, EigensolverTraits>::defect(
    const Quaternion_vector<double>& lambda) const
{
  return m_closing.defect(transformed_edges(m_mesh, lambda));
}

template <class SolverTraits, class EigensolverTraits>
Eigen::VectorXd Moving_mesh<SolverTraits, EigensolverTraits>::areas() const
{
  return m_on == Curvature_potential::On::vertices ? vertex_areas(m_mesh) : face_areas(m_mesh);
}

}  // namespace Conformal_geometry_processing

#ifndef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
namespace Conformal_geometry_processing {

extern template class Moving_mesh<Default_solver_traits, Lobpcg_eigensolver_traits>;

}  // namespace Conformal_geometry_processing
#endif

#endif
