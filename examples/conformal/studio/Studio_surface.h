// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/report/Outcome.h"

#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Conformal_deformation.h>
#include <Conformal_geometry_processing/spin/Control_point.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace conformal {

/// \brief A surface while somebody edits it: what depends on it alone is computed once, and kept
/// for many edits.
///
/// The results are those of `conformal spin` and `conformal flow`. Knows nothing but arrays, so
/// that it runs in a browser.
class Studio_surface {
 public:
  /// \throw CGP::Precondition_error if the surface is not connected, oriented, a manifold, finite
  /// and of positive areas
  explicit Studio_surface(const CGP::Mesh_view& mesh);

  /// \brief Approximates what `transform()` finds, quickly: from the last approximation if
  /// `continues`.
  /// \param rho of each vertex, in the user's frame
  void preview(const Eigen::VectorXd& rho, double bound, bool continues);

  /// Computes what `conformal spin --rho-file` does, without the second try on thin faces.
  /// \param bound as `--max-scale`; at most 1: none
  void transform(const Eigen::VectorXd& rho, double bound);

  /// \brief Computes what `conformal deform --targets` does: moves vertices to their targets.
  ///
  /// If it `continues`, the search starts from the last surface with the same points, which is
  /// faster, and finds the surface of `conformal deform` up to about 1 % of the change of
  /// curvature.
  /// \param bound as for `transform()`
  void deform(const std::vector<CGP::internal::Control_point>& points, double bound,
              bool continues);

  /// Takes the next step of the conformal Willmore flow of the surface.
  void flow();

  // The result of the last of these calls.
  const CGP::Points& positions() const { return m_positions; }
  Eigen::VectorXd quality() const;  ///< Q of each face
  const Outcome& outcome() const { return m_outcome; }

 private:
  CGP::Curvature_potential in_mesh(const Eigen::VectorXd& rho) const;
  CGP::Spin_transformation& transformation(double bound);
  void keep(CGP::Spin_result result);

  CGP::Mesh_view m_mesh;
  double m_unit;  // of the user's frame
  std::optional<CGP::Spin_transformation> m_transformation;
  double m_bound = 0;  // of it
  std::optional<CGP::internal::Conformal_deformation> m_deformation;
  double m_deformation_bound = 0;
  std::optional<CGP::Conformal_willmore_flow> m_flow;
  int m_flow_steps = 0;
  double m_flow_energy = 0;  // before the first of them
  CGP::Points m_positions;
  Outcome m_outcome;
};

}  // namespace conformal
