// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the binormals of a surface, turned t times as far as the binormals of one surface turn to
/// become those of another; 3 x number of boundary vertices. Blends of surfaces with boundary
/// prescribe them, because any binormals can be realised.
///
/// The rotation is expressed in the frame of the boundary vertex, so t = 0 gives the binormals of
/// `start`, and t = 1 those of `to` if `start` is `from`.
/// \param from,to,start of the same connectivity; `to` is aligned with `from`
Points turned_binormals(const Mesh_view& from, const Mesh_view& to, const Mesh_view& start,
                        double t);

}  // namespace Conformal_geometry_processing
