// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_REQUIRE_CONDITION_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_REQUIRE_CONDITION_H

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>

#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief checks that a condition fits the surface.
///
/// \throw Precondition_error if a condition other than `free` is set and there is no boundary; if
/// the number of targets or normals is not that of the boundary vertices; if one is zero or not
/// finite; if the direction is the normal (not elliptic), zero or not finite; if the boundary of
/// the surface folds back at a vertex, which then has no frame
void require_condition(const Surface_ref& surface, const Boundary_condition& condition,
                       const std::string& function);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/require_condition_impl.h>
#endif

#endif
