// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

using namespace Conformal_geometry_processing;

/// \ingroup PkgConcepts
/// \cgalConcept
///
/// \brief where a flow of curvature leads: the rate at which the curvature of a surface should
/// change. Constraints, filter and step size are the business of the flow.
///
/// The parameter may be a `Surface_ref` instead, to which a mesh converts: then flows with
/// mollification take the direction on their triangulation, in its unit of length.
///
/// Headers of these types:
/// - `Conformal_geometry_processing::Mesh_view`,
///   `Conformal_geometry_processing/mesh/Mesh_view.h`
/// - `Conformal_geometry_processing::Surface_ref`,
///   `Conformal_geometry_processing/mesh/Surface_ref.h`
///
/// \cgalHasModelsBegin
/// \cgalHasModels{`Conformal_geometry_processing::Willmore_direction`}
/// \cgalHasModelsEnd
class CurvatureDirection {
 public:
  /// one finite number per vertex, in 1/length of the mesh: the rate of change of H |df|, by |df|
  Eigen::VectorXd operator()(const Mesh_view& mesh) const;

  /// what decreases along the direction, a positive number. Need not be there: then any step is
  /// accepted that is conformal enough, and the Willmore energy is reported.
  double energy(const Mesh_view& mesh) const;
};
