// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/curves/Polygon_lengths.h>
#include <Conformal_geometry_processing/exceptions.h>

#include <string>

/// \file curve_requirements.h
/// \brief Requirements on polygons, checked before a flow.
namespace Conformal_geometry_processing {

/// An edge is rejected if it is shorter than this fraction of the whole polygon, because its
/// direction is then determined by the rounding of the coordinates
constexpr double relative_length_tolerance = 1e-14;

/// A turn is rejected if it differs from a half turn by less than this angle, because its sign is
/// then determined by the rounding of the coordinates
constexpr double half_turn_tolerance = 1e-10;

/// \ingroup PkgCurves
/// Requires at least three points with finite coordinates, none equal to the next one, and no turn
/// by +-pi
/// \param points 2 x m
/// \throw Precondition_error naming `function` and the first point that breaks a rule
void require_polygon(const internal::Plane_points& points, bool is_closed,
                     const std::string& function);

}  // namespace Conformal_geometry_processing
