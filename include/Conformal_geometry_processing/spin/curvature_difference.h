// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the rho that transforms a surface into a conformally equivalent one: the difference of
/// their mean curvature half-densities, (H~ |df~| - H |df|) / |df| [CGP 4.4, (4.6)]; on vertices,
/// in 1/length of the mesh.
///
/// Half-densities can be added: t rho gives surfaces between and beyond the two, and rho of one
/// pair changes a third surface of the same conformal class in the same way. The transformation by
/// rho reproduces the other surface up to a similarity and O(h^2).
/// \param positions of the other surface, 3 x |V|
/// \throw Precondition_error if their number is wrong
Curvature_potential curvature_difference(const Mesh_view& mesh, const Points& positions);

/// \ingroup PkgSpin
/// \brief transfers rho from one surface to another of the same connectivity, with the half-density
/// rho |df| fixed; on vertices or faces, as the given one.
/// \pre rho has the size for `from`, and areas are positive
Curvature_potential transferred(const Curvature_potential& rho, const Mesh_view& from,
                                const Mesh_view& to);

}  // namespace Conformal_geometry_processing
