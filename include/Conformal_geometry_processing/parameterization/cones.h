// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Quaternionic_linear_algebra/algebra/Hermitian_sparse_matrix.h>

#include <Eigen/Core>

#include <array>
#include <complex>
#include <memory>
#include <optional>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// a vertex where a metric that is flat elsewhere keeps a curvature
struct Cone {
  int vertex;
  std::optional<double> defect = {};  ///< 2 pi minus the angle
};

/// cones, and the metric exp(2 u) times that of the surface which is flat outside them, to first
/// order: L u = defects - K
struct Cone_metric {
  std::vector<Cone> cones;    ///< with defects
  Eigen::VectorXd log_scale;  ///< u of each vertex, with mean zero over the area
};

/// \brief Places cones such that areas change little in the conformal metric that is flat outside
/// them.
///
/// Each cone is placed where curvature decreases the variance of u most, after those before it; the
/// defects that are not given then minimize it, between -pi and pi each where that is possible. So
/// the variance falls with the number of cones. On a closed surface they sum to 2 pi chi [Gauss and
/// Bonnet]. A boundary takes what they leave: u is constant there, which of all boundary values
/// gives the least Dirichlet energy of u, and no cone lies on it. One factorization, and two solves
/// for each cone.
/// \param count how many, not more than inner vertices; at least 4 chi / 3 on a closed surface
/// \param first inner vertices that are cones, with defects or without, at most `count`
/// \pre the mesh is connected
Cone_metric place_cones(const Mesh_view& mesh, int count, const std::vector<Cone>& first = {});

/// Two edges whose images in the plane are to differ by a similarity: both sides of a cut, or
/// neighbours at the boundary
struct Seam {
  std::array<int, 2> left, right;
  std::complex<double> ratio;  ///< z[right[1]] - z[right[0]] by z[left[1]] - z[left[0]]
};

/// \brief The seams of a surface that was cut open to a disk through the cones of a metric that is
/// flat elsewhere, exp(2 u) times its own, and those of its boundary before.
///
/// Crossing an edge turns the frame of a face by the connection of Levi-Civita, and by
/// w_ij (u_i - u_j), the flux of u: around a vertex these add up to L u = defect - K, so that the
/// sum is flat outside the cones [Crane et al. 2010]. Frames that agree inside of the disk differ
/// by a rotation at each seam. Neighbours at the boundary, where u is constant, keep the ratio of
/// their lengths, and turn by their angle in this metric.
/// \param origin of each vertex, the same for copies of the same one
/// \param log_scale u of each vertex, from `place_cones()`
std::vector<Seam> seams_of(const Mesh_view& mesh, const std::vector<int>& origin,
                           const Eigen::VectorXd& log_scale);

/// The vertex graph with entries for all pairs of vertices of a seam
std::shared_ptr<const Sparse_pattern> graph_with_seams(const Mesh_view& mesh,
                                                       const std::vector<Seam>& seams);

/// \brief Adds to an energy on that graph the squares of what images miss of their ratios, times
/// a weight: `stiffness` is that of the springs that join the two sides.
void add_seams(const std::vector<Seam>& seams, double stiffness,
               Hermitian_sparse_matrix<std::complex<double>>& energy);

}  // namespace Conformal_geometry_processing::internal
