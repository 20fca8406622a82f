// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

using namespace Conformal_geometry_processing;

/// \ingroup PkgConcepts
/// \cgalConcept
///
/// \brief watches the flow of a curve while it runs, and may stop it.
///
/// All functions are called in the thread of the caller. What they throw passes through; an
/// `Isometric_curve_flow` is at its last complete step then, and `isometric_curve_flow()` has
/// written nothing. A model need be neither copied nor moved: it is passed as
/// `parameters::visitor(std::ref(v))`.
///
/// Headers of these types:
/// - `Conformal_geometry_processing::Curve_step_report`,
///   `Conformal_geometry_processing/curves/Isometric_curve_flow.h`
/// - `Conformal_geometry_processing::Isometric_curve_flow`,
///   `Conformal_geometry_processing/curves/Isometric_curve_flow.h`
///
/// \cgalHasModelsBegin
/// \cgalHasModels{`Conformal_geometry_processing::Curve_flow_visitor`}
/// \cgalHasModelsEnd
class CurveFlowVisitor {
 public:
  /// called once, with the points the flow starts from, one per column, and their energy
  void on_flow_begin(const Eigen::Matrix2Xd& points, double energy);

  /// asked before every step: `false` stops the flow
  bool go_further();

  /// called after every accepted step, with the new points
  void on_step_end(const Curve_step_report& report, const Eigen::Matrix2Xd& points);
};
