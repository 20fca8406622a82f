// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the rho of a bump of height h along the normals, rho = Delta h / 2 with the positive
/// semidefinite Laplacian; on vertices, in 1/length [CGP 6.2, where the factor is missing].
///
/// A displacement by h N shears the surface unless h is small; the spin transformation by rho gives
/// a bump of about the same height without shear. On planes and spheres H |df| changes by rho |df|
/// to first order in h; on other surfaces also by -(H^2 - K) h |df|, which is omitted because the
/// displacement is not conformal there. Low bumps of standard deviation s come out within 5 % on
/// spheres and on limbs of radius 4 s and more, where edges are at most half of s; on limbs of 3 s
/// they come out up to 10 % too high. Higher ones come out higher: on a plane by 5 % for two thirds
/// of s, by 29 % for 1.5 s.
///
/// The Laplacian is M_V^-1 L. The equation sees the means of rho on faces, so that a bump would
/// lose 10 % where s is two edges; rho is raised against that by one step of Richardson's
/// iteration, which leaves the square of what the averaging takes away. At the boundary, where L h
/// also contains the slope of h, rho is the mean of the interior neighbours. O(|F|).
/// \param height |V| numbers, in the units of the mesh
/// \throw Precondition_error if their number is wrong
Curvature_potential curvature_of_displacement(const Mesh_view& mesh, const Eigen::VectorXd& height);

}  // namespace Conformal_geometry_processing
