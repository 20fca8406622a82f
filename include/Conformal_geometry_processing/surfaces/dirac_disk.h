// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <Eigen/Core>

#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgSurfaces
/// \brief Computes the surface for the eigenvalue of D nearest to `wanted`, with binormals
/// preserved: for plane domains a Dirac surface, whose curvature half-density is a multiple of its
/// length half-density [CGP 6.5.2].
///
/// For a plane domain the eigenvalues are the square roots, of either sign, of the Dirichlet and
/// Neumann eigenvalues of the Laplacian: on the unit disk the zeros of Bessel functions and of
/// their derivatives. Many of these surfaces have branch points, around which coarse meshes fold
/// over; the report is false if any face flips.
/// \param wanted in 1/length; the eigenvalue itself is `wanted` plus that of the report
/// \throw Precondition_error if the mesh is not suitable, or closed
/// \throw Solver_error if a factorization fails
Spin_result dirac_disk(const Mesh_view& mesh, double wanted, const Dirac_options& options = {},
                       const std::string& function = "dirac_disk");

}  // namespace Conformal_geometry_processing
