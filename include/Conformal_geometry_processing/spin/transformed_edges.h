// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the integral of conjugate(lambda) df lambda along the edge e, with lambda linear from l_i
/// to l_j [CGP (5.4)]:
///
///     e~ = 1/3 l_i^ e l_i + 1/6 l_i^ e l_j + 1/6 l_j^ e l_i + 1/3 l_j^ e l_j,   l^ = conjugate(l),
///
/// which is purely imaginary. Constant lambda gives conjugate(lambda) e lambda exactly.
Eigen::Vector3d transformed_edge(const Eigen::Vector3d& e, const Quaternion<double>& l_i,
                                 const Quaternion<double>& l_j);

/// \ingroup PkgSpin
/// \brief the edge vectors of the spin transformed surface, df~ = conjugate(lambda) df lambda
/// integrated along each edge; |E| x 3, edge k runs i -> j with i < j.
/// \param lambda |V| quaternions
Eigen::MatrixX3d transformed_edges(const Surface_ref& surface,
                                   const Quaternion_vector<double>& lambda);

namespace internal {

/// \brief |d0 f - e| / |e|: how far the edges of positions f are from given edge vectors e.
///
/// The norms use |w|, because w is negative opposite large angles and then defines no norm.
/// \param weights w, `cotan_weights()` of the surface, |E|
/// \param f 3 x |V| \param edges |E| x 3, not all zero
double closure_residual(const Surface_ref& surface, const Eigen::VectorXd& weights, const Points& f,
                        const Eigen::MatrixX3d& edges, const Surface_part& part = {});

/// \brief the change of `transformed_edges()` with lambda, |E| x 3: they are quadratic in it.
Eigen::MatrixX3d edge_change(const Surface_ref& surface, const Quaternion_vector<double>& lambda,
                             const Quaternion_vector<double>& dlambda);

/// \brief the transpose: the gradient q of the sum of <y_k, e~_k> over the edges, |V|: its change
/// is Re <q, dlambda>.
/// \param y |E| x 3
Quaternion_vector<double> edge_gradient(const Surface_ref& surface,
                                        const Quaternion_vector<double>& lambda,
                                        const Eigen::MatrixX3d& y);

}  // namespace internal

/// \ingroup PkgSpin
/// \brief the rho on faces that minimises (D - rho) mu in each face: Re(conjugate(B mu) D mu) / |B
/// mu|^2 [CGP 6.3]; in 1/length. Zero where the mean B mu of a face vanishes,
/// or its area is below a millionth of the mean one.
///
/// If mu solves a Dirac equation, the result is rho + gamma of that equation.
/// \param mu |V|
Curvature_potential curvature_of_spins(const Surface_ref& surface,
                                       const Quaternion_vector<double>& mu);

}  // namespace Conformal_geometry_processing
