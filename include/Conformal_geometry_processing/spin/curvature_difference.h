// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin/Nearest_spin_transformation.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>

#include <Eigen/Core>

#include <string>

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

/// \ingroup PkgSpin
/// \brief what is requested of a blend: at a boundary the `turned_binormals()`, which determine
/// whether edges close up around holes.
/// \param to positions, placed near to `from` first
/// \param request what is requested otherwise
Spin_transformation_options blend_request(const Mesh_view& from, const Points& to,
                                          const Mesh_view& start, double t,
                                          Spin_transformation_options request = {});

/// \ingroup PkgSpin
/// \brief the rho that transforms a surface into another one, or into the conformal surface nearest
/// to it; on vertices or faces, in 1/length of the mesh.
///
/// `curvature_difference()` [CGP 4.4, (4.6)] misses the other surface by O(h^2). This function
/// searches for the rho that arrives, by `Nearest_spin_transformation`, up to a distance that
/// nobody sees. On surfaces with boundary, transformations by it prescribe the binormals of the
/// other surface (`turned_binormals()`). Where no result is nearer to the other surface than the
/// mesh, or none has these binormals, the plain difference is returned; also if the search is
/// cancelled.
///
/// The spins of that search are not an eigenvector, so its rho is corrected by the differences of
/// curvature that a few transformations by it leave.
///
/// Costs what these cost: three to ten factorizations, and some hundred solves.
/// \param positions of the other surface, 3 x |V|
/// \param distance_tolerance see `Nearest_spin_options`
/// \param function named in exceptions
/// \throw Precondition_error as the constructor of `Nearest_spin_transformation` does
/// \throw Solver_error if a factorization fails
Curvature_potential nearest_curvature_difference(
    const Mesh_view& mesh, const Points& positions,
    double distance_tolerance = Nearest_spin_options().distance_tolerance,
    const Dirac_options& options = {},
    const internal::Go_further& go_further = internal::Always_go_further(),
    const std::string& function = "nearest_curvature_difference");

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
