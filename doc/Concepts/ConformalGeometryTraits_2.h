// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

using namespace Conformal_geometry_processing;

/// \ingroup PkgConcepts
/// \cgalConcept
///
/// \brief what the library asks of points of the plane: coordinates in, points out.
///
/// All computations run in `double`, whatever the number type. Functors are taken from the instance
/// that is passed as `geom_traits`, so traits may have a state.
///
/// \cgalHasModelsBegin
/// \cgalHasModels{Every %CGAL kernel}
/// \cgalHasModelsEnd
class ConformalGeometryTraits_2 {
 public:
  /// \name Types
  /// @{

  /// a number: constructed from `double`, turned into one by `CGAL::to_double()`
  typedef unspecified_type FT;

  /// a point; copies are made, a default is not
  typedef unspecified_type Point_2;

  /// a functor with `FT operator()(const Point_2& p) const`, the first coordinate of p
  typedef unspecified_type Compute_x_2;

  /// likewise, the second coordinate
  typedef unspecified_type Compute_y_2;

  /// a functor with `Point_2 operator()(const FT& x, const FT& y) const`
  typedef unspecified_type Construct_point_2;

  /// @}

  /// \name Operations
  /// @{

  /// the functor for x
  Compute_x_2 compute_x_2_object() const;

  /// the functor for y
  Compute_y_2 compute_y_2_object() const;

  /// the functor that makes points
  Construct_point_2 construct_point_2_object() const;

  /// @}
};
