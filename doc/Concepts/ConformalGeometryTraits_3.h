// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

using namespace Conformal_geometry_processing;

/// \ingroup PkgConcepts
/// \cgalConcept
///
/// \brief what the library asks of points: coordinates in, points out.
///
/// All computations run in `double`, whatever the number type: the results of an exact kernel are
/// rounded ones. Functors are taken from the instance that is passed as `geom_traits`, so traits
/// may have a state.
///
/// \cgalHasModelsBegin
/// \cgalHasModels{Every %CGAL kernel}
/// \cgalHasModelsEnd
class ConformalGeometryTraits_3 {
 public:
  /// \name Types
  /// @{

  /// a number: constructed from `double`, turned into one by `CGAL::to_double()`
  typedef unspecified_type FT;

  /// a point; copies are made, a default is not
  typedef unspecified_type Point_3;

  /// a functor with `FT operator()(const Point_3& p) const`, the first coordinate of p
  typedef unspecified_type Compute_x_3;

  /// likewise, the second coordinate
  typedef unspecified_type Compute_y_3;

  /// likewise, the third coordinate
  typedef unspecified_type Compute_z_3;

  /// a functor with `Point_3 operator()(const FT& x, const FT& y, const FT& z) const`
  typedef unspecified_type Construct_point_3;

  /// @}

  /// \name Operations
  /// @{

  /// the functor for x
  Compute_x_3 compute_x_3_object() const;

  /// the functor for y
  Compute_y_3 compute_y_3_object() const;

  /// the functor for z
  Compute_z_3 compute_z_3_object() const;

  /// the functor that makes points
  Construct_point_3 construct_point_3_object() const;

  /// @}
};
