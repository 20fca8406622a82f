// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <complex>
#include <memory>

namespace Conformal_geometry_processing {

/// \ingroup PkgParameterization
/// \brief Assembles the conformal energy of maps z = a + i b to the plane: z^H L_C z = sum over the
/// faces of area |J grad a - grad b|^2, the Dirichlet energies of a and b minus twice the area of
/// the image.
///
/// It is |D psi|^2 for psi = a - b N without the component of D psi along the normal, where N is
/// the normal of each face [CGP 6.1]. |V| x |V|, complex Hermitian, positive semidefinite: zero for
/// constants, and otherwise only for similarities of flat surfaces. L_C (i z) = i L_C z, so it is
/// invariant under rotations of the image. Its real part is the cotan Laplacian, its imaginary part
/// +-1/2 on the edges of the boundary. Dimensionless.
/// \param pattern `vertex_graph(mesh)`
Hermitian_sparse_matrix<std::complex<double>> conformal_energy(
    const Mesh_view& mesh, std::shared_ptr<const Sparse_pattern> pattern);

/// \ingroup PkgParameterization
/// Assembles the conformal energy with its own pattern
Hermitian_sparse_matrix<std::complex<double>> conformal_energy(const Mesh_view& mesh);

}  // namespace Conformal_geometry_processing
