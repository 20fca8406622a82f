// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Poisson_reconstruction.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>

#include <Eigen/Core>

#include <string>

namespace Conformal_geometry_processing {
namespace internal {

/// A member of the associated family, and its closure residual
struct Associated_surface {
  Points positions;             ///< 3 x |V|, with mean zero
  double closure_residual = 0;  ///< relative; tends to zero if the surface is minimal and simply
                                ///< connected
};

}  // namespace internal

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
