// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>
#include <Quaternionic_linear_algebra/direct/Solver_ref.h>

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <optional>

namespace Conformal_geometry_processing {

/// \ingroup PkgMeasure
/// \brief how the change of curvature that a map has made agrees with the rho that was requested:
/// measured on positions, whatever method has found them.
///
/// The realised change is (H~ |df~| - H |df|) / |df|, as in `curvature_difference()`. Both it and
/// rho are smoothed over `smoothing_length` times the radius of the sphere of the same area, since
/// single values of H do not converge under refinement. All numbers are dimensionless.
struct Realised_curvature {
  /// l / R with R = sqrt(area / 4 pi)
  static constexpr double smoothing_length = 0.15;

  double share = 0;        ///< norm of the realised change, relative to that of rho
  double correlation = 0;  ///< between the two
  double distance = 0;     ///< norm of their difference, relative to that of rho; 1 if nothing is
                           ///< realised
  double wrong_sign = 0;   ///< where |rho| exceeds a quarter of its largest value: the share of the
                           ///< area where the realised change does not have the sign of rho
  double seen_share = 0;   ///< norm of the smoothed rho, relative to that of rho: small where the
                           ///< features of rho are smaller than the smoothing length
  double judged_share = 0;  ///< of the area; without the rim and vertices without area

  /// \brief how much of rho is realised, in [-1, 1]: the correlation, times the share if that is
  /// below 1. Excess does not make up for a wrong shape.
  double agreement() const;
};

/// \ingroup PkgMeasure
/// \brief Measures the curvature that a map has realised.
///
/// With h_i = <N_i, grad_i area> / 2, the integral of H around vertex i, and barycentric areas M:
/// the integrals of the realised change are h~_i sqrt(M_i / M~_i) - h_i, which do not depend on the
/// sizes of the surfaces, and those of rho are M_i rho_i; rho on faces contributes a third to each
/// corner. Their means are subtracted, and both are smoothed by (M + l^2 L)^-1, with the cotan
/// Laplacian L. Left out, with M_i = 0, are vertices at the boundary, where h contains the
/// curvature of the boundary curve, and vertices that have nearly no area before or after. A face
/// of area zero contributes nothing. Costs one factorization of a real matrix and a solution with
/// two right-hand sides.
///
/// \param positions of the transformed surface, 3 x |V|
/// \param rho in 1/length of the mesh
/// \param constants_have_effect whether means are kept, as for free boundaries
/// \returns nothing if a position is not finite, or rho vanishes up to its mean
/// \throw Precondition_error if a number of values is wrong
/// \throw Solver_error if the matrix cannot be factored
std::optional<Realised_curvature> realised_curvature(const Mesh_view& mesh, const Points& positions,
                                                     const Curvature_potential& rho,
                                                     bool constants_have_effect = false,
                                                     const Spin_solvers& solvers = {});

namespace internal {

/// \throw Solver_error if a step of smoothing failed
void check_smoothing(const char* step, Solver_status status);

/// rho at the vertices: on faces, the mean of those around, weighted by area
Eigen::VectorXd values_at_vertices(const Mesh_view& mesh, const Curvature_potential& rho);

/// \brief (L + masses)^-1 b of the own vertices
using Smooth = std::function<Block<double>(const Block<double>& b, const Eigen::VectorXd& masses)>;

/// \brief the same of a surface in parts.
/// \param mesh,positions,rho,surface of the part; see below
std::optional<Realised_curvature> realised_curvature(const Mesh_view& mesh, const Points& positions,
                                                     const Eigen::VectorXd& rho,
                                                     bool constants_have_effect,
                                                     const Surface_ref& surface,
                                                     const Smooth& smooth,
                                                     const Surface_part& part = {});

/// \brief the same with the Laplacian of another triangulation of the surface.
/// \param mesh the faces that are judged; where thin ones are left out, the gradient of area lacks
/// little but tangential components, and their normals after a map, which are arbitrary
/// \param rho `values_at_vertices()` of all faces
/// \param surface has the vertices of the mesh; its boundary is the rim
/// \param pattern `vertex_graph(surface)` \param solver has analyzed it
std::optional<Realised_curvature> realised_curvature(const Mesh_view& mesh, const Points& positions,
                                                     const Eigen::VectorXd& rho,
                                                     bool constants_have_effect,
                                                     const Surface_ref& surface,
                                                     std::shared_ptr<const Sparse_pattern> pattern,
                                                     Solver_ref<double>& solver);

}  // namespace internal
}  // namespace Conformal_geometry_processing
