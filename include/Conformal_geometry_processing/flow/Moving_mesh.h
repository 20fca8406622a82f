// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_MOVING_MESH_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_MOVING_MESH_H

#include <Conformal_geometry_processing/flow/Closing_constraints.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgFlow
/// \brief the surface that `Closing_spin_transformation` takes from step to step, and what keeps
/// it closed around its handles: here the mesh; also the concept of its parameter `Moving`.
template <class SolverTraits, class EigensolverTraits>
class Moving_mesh {
 public:
  using Transformation = Spin_transformation<SolverTraits, EigensolverTraits>;

  /// \param transformation of the mesh; must outlive the object
  Moving_mesh(Transformation& transformation, const Mesh_view& mesh, Exactness exactness,
              Curvature_potential::On on);

  Moving_mesh(const Moving_mesh&) = delete;
  Moving_mesh& operator=(const Moving_mesh&) = delete;

  /// on which maps are measured
  static const Mesh_view& measured(const Mesh_view& mesh) { return mesh; }

  /// \brief finds the constraints of the present surface, see `Closing_constraints::update()`.
  /// \throw Solver_error if a factorization fails
  void update() { m_closing.update(m_transformation.reconstruction().solver()); }

  /// what rho must be orthogonal to
  Constraint_basis basis() const { return m_closing.basis(); }

  /// of the surface with spins lambda, see `Closing_constraints::defect()`
  double defect(const Quaternion_vector<double>& lambda) const;

  /// follows the transformation
  /// \pre it has moved to these positions
  void move_to(const Points& positions) { m_mesh.set_positions(positions); }

  const Points& positions() const { return m_mesh.positions(); }

  /// that belong to the values of rho; of the surface of the last `move_to()`
  Eigen::VectorXd areas() const;

 private:
  Transformation& m_transformation;
  Curvature_potential::On m_on;
  Mesh_view m_mesh;
  Closing_constraints<SolverTraits, EigensolverTraits> m_closing;
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/flow/Moving_mesh_templates.h>
#endif

#endif
