// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {
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
