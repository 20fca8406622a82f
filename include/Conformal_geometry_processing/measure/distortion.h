// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {
namespace internal {

/// \brief Statistics of a quantity on a surface.
struct Distribution {
  double mean = 0;  ///< weighted
  double p99 = 0;   ///< 99 % of the weight lies at or below
  double max = 0;
};

/// the least value with at least a share of the weight at or below it; O(n log(range))
/// \param values more than -infinity
double weighted_quantile(const Eigen::VectorXd& values, const Eigen::VectorXd& weights,
                         double share, const Surface_part& part = {});

/// \brief the linear maps of the faces to their images, measured in one pass.
struct Face_maps {
  Eigen::VectorXd quasi_conformal;   ///< `quasi_conformal_errors()`
  Eigen::VectorXd areas, new_areas;  ///< of the faces

  /// \param positions the new ones, 3 x |V|
  Face_maps(const Mesh_view& mesh, const Points& positions, const Surface_part& part = {});

  Eigen::VectorXd length_scales() const;  ///< sqrt(new area / old area)
};

}  // namespace internal

/// \ingroup PkgMeasure
/// Returns statistics of values with positive weights, usually areas
internal::Distribution distribution(const Eigen::VectorXd& values, const Eigen::VectorXd& weights,
                                    const internal::Surface_part& part = {});

/// \ingroup PkgMeasure
/// Returns the share of the weight in each of `bins` intervals of equal width from `low` to `high`;
/// values outside are assigned to the first or the last one, NaN to the first
Eigen::VectorXd histogram(const Eigen::VectorXd& values, const Eigen::VectorXd& weights, int bins,
                          double low, double high);

/// \ingroup PkgMeasure
/// \brief Returns Q >= 1 for each face: the ratio of the singular values of the linear map between
/// the old and the new triangle, 1 if it is a similarity [CGP 5.8.1].
///
/// Infinite if the new triangle has area zero. First order in the edge length even for exactly
/// conformal maps; `length_cross_ratio_change()` is the discretely exact measure.
/// \param positions the new ones, 3 x |V|
Eigen::VectorXd quasi_conformal_errors(const Mesh_view& mesh, const Points& positions);

/// \ingroup PkgMeasure
/// Returns statistics of the quasi-conformal errors, weighted by the areas of the old faces
internal::Distribution quasi_conformal_error(const Mesh_view& mesh, const Points& positions);

/// \ingroup PkgMeasure
/// Returns the factor by which the map scales lengths, sqrt(new area / old area), for each face
/// \param positions the new ones, 3 x |V|
Eigen::VectorXd length_scales(const Mesh_view& mesh, const Points& positions);

namespace internal {

/// measures of the area distortion of a map
struct Area_distortion {
  double min_scale = 1, max_scale = 1;  ///< range of `length_scales()`
  double log_deviation = 0;  ///< standard deviation of the log of the scale, weighted by area
  /// share of the old area that shrank below a tenth of the root mean square scale, or of the new
  /// area that grew beyond ten times it, whichever is larger: the same for the inverse map
  double collapsed_share = 0;

  /// share of the old area in each half octave of the scale relative to the root mean square, from
  /// 1/16 to 16; what is outside is in the first or the last one
  static constexpr double octaves = 4;
  /// unaligned, so that its layout is that of the compiled library with any vector unit
  using Shares = Eigen::Matrix<double, 16, 1, Eigen::DontAlign>;
  Shares histogram = Shares::Zero();
};

Area_distortion area_distortion(const Face_maps& maps, const Surface_part& part = {});

/// Deviation of a map from discrete conformality; zero for Moebius transformations
struct Length_cross_ratio_change {
  double rms = 0;  ///< over the interior edges
  double max = 0;  ///< absolute
};

}  // namespace internal

/// \ingroup PkgMeasure
/// Computes the area distortion from the mesh to the new positions
internal::Area_distortion area_distortion(const Mesh_view& mesh, const Points& positions);

/// \ingroup PkgMeasure
/// \brief Returns the logarithm of the length cross-ratio l_il l_jk / (l_lj l_ki) of each interior
/// edge ij with the opposite vertices k (left) and l (right); zero at the boundary. |E| numbers.
///
/// Two meshes of the same connectivity are discretely conformally equivalent if and only if their
/// length cross-ratios agree; Moebius transformations of the vertices preserve them.
Eigen::VectorXd log_length_cross_ratios(const Mesh_view& mesh, const Points& positions);

/// \ingroup PkgMeasure
/// Returns the change of the log length cross-ratios from the mesh to the new positions, 3 x |V|
internal::Length_cross_ratio_change length_cross_ratio_change(
    const Mesh_view& mesh, const Points& positions, const internal::Surface_part& part = {});

/// \ingroup PkgMeasure
/// \brief Returns the expected normals of the faces of a surface without folds: the sum of the
/// area-weighted normals of their corners; 3 x |F|, not of unit length.
Points neighbourhood_normals(const Mesh_view& mesh);

/// \ingroup PkgMeasure
/// \brief Returns the expected normals of the faces under a deformation that creates and removes no
/// folds: the neighbourhood normals of the new surface, reversed if a face was opposite to its
/// neighbourhood before; 3 x |F|, not of unit length.
///
/// If a face was perpendicular to its neighbourhood, or either has no normal (area zero, faces that
/// cancel out), the orientation is undefined, and the new normal itself is returned.
/// \param positions the new ones, 3 x |V|
Points neighbourhood_normals(const Mesh_view& before, const Points& positions);

/// \ingroup PkgMeasure
/// Returns the number of faces whose new normal makes an obtuse angle with the expected one, or
/// that have area zero
/// \param positions the new ones, 3 x |V|
/// \param expected 3 x |F|, for instance the old normals rotated by the spins of the faces
int flipped_faces(const Mesh_view& mesh, const Points& positions, const Points& expected,
                  const internal::Surface_part& part = {});

}  // namespace Conformal_geometry_processing
