// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DIRAC_ENERGY_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DIRAC_ENERGY_H

#include <Conformal_geometry_processing/algebra/Hermitian_sparse_matrix.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief assembles X = (D - R)^H M_F (D - R), face by face [CGP Alg. 2].
///
/// X is |V| x |V|, quaternionic, Hermitian and positive semidefinite; dimensionless. For rho = 0
/// its real part is the cotan Laplacian and its kernel on a closed surface are the constants. A
/// face with corners i, j, edges e_i, area A and curvatures rho_i adds
///
///     X_ij += -e_i e_j / (4A) + (rho_i e_j - rho_j e_i) / 6 + A rho_i rho_j / 9,
///
/// which for rho on faces is the other formula of [CGP Alg. 2]. O(|F|), writes in place.
/// \param X a matrix on `vertex_graph(mesh)`; its values are replaced
/// \pre no face has area zero
void assemble_dirac_energy(const Mesh_view& mesh, const Curvature_potential& rho,
                           Hermitian_sparse_matrix<Quaternion<double>>& X);

/// \ingroup PkgOperators
/// X on a pattern of its own
Hermitian_sparse_matrix<Quaternion<double>> dirac_energy(const Mesh_view& mesh,
                                                         const Curvature_potential& rho);

/// \ingroup PkgOperators
/// \brief B^H M_F (D - R), |V| x |V|, the right-hand side of the generalized problem [CGP (5.2)].
///
/// Hermitian, indefinite, in units of length. A face adds -e_j / 6 - A rho / 9 to entry (i, j).
/// \pre rho is on faces, and the surface is closed: otherwise the matrix is not Hermitian
Hermitian_sparse_matrix<Quaternion<double>> dirac_form(const Mesh_view& mesh,
                                                       const Curvature_potential& rho);

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/operators/dirac_energy_impl.h>
#endif

#endif
