// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgForms
/// \brief The inner products <h_i, h_j> of the harmonic forms of the cohomology classes of
/// `closed_generators()`, 2G x 2G: conformally invariant, and by Torelli's theorem they determine
/// the conformal type. Surfaces of the same connectivity have the same classes.
///
/// One factorization of the Laplacian and 2G solves.
/// \param mesh closed
/// \throw Solver_error if the factorization fails
Eigen::MatrixXd harmonic_energies(const Mesh_view& mesh);

/// \ingroup PkgForms
/// \brief The distance of two such matrices: (max log t - min log t) / 2 over the eigenvalues t of
/// A^-1 B, which are t and 1 / t but for the error of the discrete energies, a common factor.
///
/// For tori it is the hyperbolic distance of their moduli: for rectangles of proportions b and c,
/// |log(b / c)|. Infinite if a matrix is not positive definite.
double conformal_type_distance(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

}  // namespace Conformal_geometry_processing::internal
