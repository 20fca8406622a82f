// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>

#include <Eigen/Core>

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

/// \ingroup PkgParameterization
/// \brief Assembles the energy of the thesis for maps z = a + i b: |D psi|^2 of psi = a - b N
/// without the component along the normals of the faces, where N is a normal of each *vertex*
/// [CGP 6.1].
///
/// sum over the faces k of area |J grad a - sum_j b_j <N_j, N_k> grad phi_j|^2: it differs from
/// `conformal_energy()` by the cosines <N_j, N_k>, which tend to 1 under refinement of smooth
/// surfaces. Otherwise the energy does not measure conformality: it does not vanish for constant b
/// and is not invariant under rotations of the image, so maps of scans are much worse. (The thesis
/// has a + b N, which gives the conjugate of the map.)
///
/// Real, 2|V| x 2|V| on `expanded_pattern(graph, 2)`, rows a_i, b_i; positive semidefinite.
/// \param normals 3 x |V|, of unit length \param graph `vertex_graph(mesh)`
Hermitian_sparse_matrix<double> vertex_normal_energy(const Mesh_view& mesh, const Points& normals,
                                                     const Sparse_pattern& graph);

}  // namespace Conformal_geometry_processing
