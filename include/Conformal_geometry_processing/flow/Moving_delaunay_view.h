// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_MOVING_DELAUNAY_VIEW_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_MOVING_DELAUNAY_VIEW_H

#include <Conformal_geometry_processing/flow/Closing_constraints.h>
#include <Conformal_geometry_processing/forms/Dirac_energy_inverse.h>
#include <Conformal_geometry_processing/mesh/well_shaped_faces.h>
#include <Conformal_geometry_processing/spin/Robust_spin_transformation.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgFlow
/// \brief what `Moving_mesh` is, of surfaces whose faces may have area zero: every step has a
/// triangulation of its own, to which the loops around handles are taken along. Its functions are
/// those of `Moving_mesh`.
template <class SolverTraits, class EigensolverTraits>
class Moving_delaunay_view {
 public:
  using Transformation = Robust_spin_transformation<SolverTraits, EigensolverTraits>;

  /// \brief takes the adjoint's constraints, whatever exactness is asked for.
  /// \param transformation of the mesh, which carries generators; must outlive the object
  /// \param on where the values of rho are
  Moving_delaunay_view(Transformation& transformation, const Mesh_view& mesh, Exactness,
                       Curvature_potential::On on);

  Moving_delaunay_view(const Moving_delaunay_view&) = delete;
  Moving_delaunay_view& operator=(const Moving_delaunay_view&) = delete;

  static Mesh_view measured(const Mesh_view& mesh) { return well_shaped_faces(mesh).mesh; }

  /// 2k solves with the Laplacian, a factorization for rho = 0, and 3k solves with that, of k loops
  void update();
  Constraint_basis basis() const;
  double defect(const Quaternion_vector<double>& lambda) const;
  void move_to(const Points& positions);

  const Points& positions() const { return m_positions; }

  const Eigen::VectorXd& areas() const { return m_areas; }

 private:
  Transformation& m_transformation;
  Curvature_potential::On m_on;
  Points m_positions;
  Eigen::VectorXd m_areas;  // of the surface before `move_to()`, until then
  Harmonic_basis m_basis;
  Eigen::MatrixXd m_functions;
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/flow/Moving_delaunay_view_templates.h>
#endif

#endif
