// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <optional>
#include <string>
#include <utility>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// both in the normalized frame of the mesh, where squares of areas neither over- nor underflow
std::pair<Mesh_view, Points> in_frame(const Mesh_view& mesh, const Points& target);

/// \ingroup PkgSpin
/// \brief returns the target of a deformation.
/// \param mollification if set, thin faces are admitted, and the spin structure is not checked
/// \throw Precondition_error unless mesh and target are connected, oriented manifolds with the same
/// faces and finite coordinates, without mollification of positive areas and, if closed, with the
/// same spin structure
Points checked_target(const Mesh_view& mesh, Points target,
                      const std::optional<double>& mollification, const std::string& function);

}  // namespace Conformal_geometry_processing::internal
