// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_REQUIRE_POTENTIAL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_REQUIRE_POTENTIAL_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>

#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \throw Precondition_error if rho has the wrong length or a value that is not finite, also after
/// conversion to 1/`unit`
void require_potential(const Mesh_view& mesh, const Curvature_potential& rho, double unit,
                       const std::string& function);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/spin/require_potential_impl.h>
#endif

#endif
