// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/flow/Fairing_patch.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgFlow
/// \brief The Willmore energy of a patch whose rim is clamped, and its derivative.
///
/// W(f) = sum |L f|_v^2 / (4 A_v) over the vertices that bend, with the cotan Laplacian L and mixed
/// Voronoi areas A, both of f: the integral of H^2, for L f = 2 H N A, whose normal part is exact
/// on spheres where no face is obtuse. At the rim, L f contains the faces outside, which stay: a
/// kink there has curvature, and so normals are kept without a condition on them.
class Bending_energy {
 public:
  /// \param f positions of the vertices of the patch
  Bending_energy(const Fairing_patch& patch, const Points& f);

  /// W; dimensionless
  double value() const { return m_value; }

  /// the derivative of W by each position, exact, in 1/length; zero at held vertices
  Points gradient() const;

  const Mesh_view& mesh() const { return m_mesh; }
  const Eigen::VectorXd& weights() const { return m_weights; }  ///< of the edges in L
  const Eigen::VectorXd& areas() const { return m_areas; }      ///< of the vertices

 private:
  void add_face(int f, Points& gradient) const;

  const Fairing_patch& m_patch;
  Mesh_view m_mesh;
  Eigen::VectorXd m_weights, m_areas;
  Points m_curvature;  // L f / A = 2 H N where the surface bends, zero elsewhere
  double m_value = 0;
};

}  // namespace Conformal_geometry_processing::internal
