// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>

#include <Eigen/Core>

#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgSurfaces
/// \brief Returns the threshold below which singular values of D - rho are considered zero on
/// surfaces with several boundary loops: 3 h / R^2 with the mean length h of the edges and pi R^2
/// the area, in 1/length.
///
/// For surfaces of revolution, plane annuli and catenoids are solutions for the same tangents;
/// their singular values tend to zero with h.
double minimal_kernel_tolerance(const Mesh_view& mesh);

namespace internal {

/// the condition whose directions are turned by a share of the way from those of the mesh to the
/// targets, if it has any
Boundary_condition part_of_turn(const Mesh_view& mesh, Boundary_condition condition, double share);

/// a transformation by rho = -share H, with the directions turned by that share
Spin_result spin_towards_minimal_surface(const Mesh_view& mesh, double share,
                                         Spin_transformation_options own,
                                         const std::string& function, const Go_further& go_further);

/// A member of the associated family, and its closure residual
struct Associated_surface {
  Points positions;             ///< 3 x |V|, with mean zero
  double closure_residual = 0;  ///< relative; tends to zero if the surface is minimal and simply
                                ///< connected
};

}  // namespace internal

/// \ingroup PkgSurfaces
/// \brief Computes the minimal surface conformally equivalent to a surface with boundary, by
/// rho = -H in one solve [CGP 6.5.3].
///
/// With lambda = sqrt(F') this includes the holomorphic functions of plane domains, and with
/// directions out of the plane the Weierstrass representation. With binormals, gamma is an
/// eigenvalue and must be zero: among the vectors of those that are, the nearest to the given
/// surface is taken, and where none is, the report says that there is no such surface.
///
/// One solve has an error that grows with the change of the surface. Where the data at the boundary
/// are refused, `Spin_report::reached` is the share of the way, from the present curvature and
/// directions, for which there is a surface, at the cost of six more solves. If it is small, the
/// steps of `conformal_willmore_flow()` with the same condition may arrive.
/// \param own boundary: usually prescribed tangents or binormals; exactness is not used; where the
/// kernel tolerance of `dirac` is zero, that is `minimal_kernel_tolerance()`
/// \throw Precondition_error if the mesh or the condition are not suitable
/// \throw Solver_error if a factorization fails
Spin_result spin_to_minimal_surface(
    const Mesh_view& mesh, Spin_transformation_options own = {Boundary_condition::tangents()},
    const std::string& function = "spin_to_minimal_surface",
    const internal::Go_further& go_further = internal::Always_go_further());

/// \ingroup PkgSurfaces
/// \brief The associated family of a minimal surface, its isometric deformations:
/// df_theta = cos(theta) df + sin(theta) df x N, which deforms catenoids to helicoids.
///
/// They are spin transformations by lambda = cos(theta/2) + sin(theta/2) N: for H = 0 the normal is
/// in the kernel of D, like 1. The Laplacian is factored once; each angle costs one solve.
class Associated_family {
 public:
  /// \param mesh a minimal surface; is copied
  /// \throw Precondition_error if the mesh is not a connected, oriented manifold with finite
  /// coordinates and positive areas
  /// \throw Solver_error if the Laplacian cannot be factored
  explicit Associated_family(const Mesh_view& mesh,
                             const std::string& function = "Associated_family",
                             const Spin_solvers& solvers = {});

  Associated_family(const Associated_family&) = delete;
  Associated_family& operator=(const Associated_family&) = delete;

  /// \param theta in radians; pi gives the point reflection of the surface
  internal::Associated_surface operator()(double theta) const;

 private:
  Mesh_view m_mesh;
  Points m_normals;
  Poisson_reconstruction m_reconstruction;
};

}  // namespace Conformal_geometry_processing
