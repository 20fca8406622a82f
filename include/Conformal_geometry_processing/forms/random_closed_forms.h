// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgForms
/// \brief random 1-forms without their co-exact parts: the generators that the thesis starts from
/// [CGP 6.4.5.1], as an alternative to `closed_generators()`.
///
/// Computes gamma = alpha - w^-1 d1^T b with d1 w^-1 d1^T b = d1 alpha for random alpha in [-1, 1).
/// Divides by the cotan weights w, which vanish opposite right angles; otherwise the matrix is
/// regular up to the constants, but indefinite if weights are negative. A matrix on the faces is
/// factored with pivoting, which is much slower than spanning trees.
///
/// \returns |E| x 2G, or 2G + loops - 1 with a boundary; almost surely no combination is exact
/// \param function named in the exception
/// \pre `require_surface(mesh)` holds
/// \throw Precondition_error if a weight is zero; the message names the first such edge
Eigen::MatrixXd random_closed_forms(const Mesh_view& mesh, unsigned seed,
                                    const std::string& function = "random_closed_forms");

}  // namespace Conformal_geometry_processing
