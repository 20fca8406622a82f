// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_FACE_SPINS_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_FACE_SPINS_H

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/algebra/rotor.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgSpin
/// \brief the spins of the similarities of the faces that come nearest to a deformation, |F| of
/// either sign [CGP 5.9, 6.3].
///
/// Between a face and its image is a linear map; its nearest rotation, times the root of its
/// determinant, is conjugate(q) v q for the edges v. Two quaternions, q and -q, belong to it.
/// \param positions of the deformed surface, 3 x |V|
/// \pre no face has area zero before or after
inline Quaternion_vector<double> face_spins(const Mesh_view& mesh, const Points& positions)
{
  // T along the first edge of the face, N its normal; and the coordinates of the third corner.
  const auto frame = [](const Eigen::Vector3d& first, const Eigen::Vector3d& second) {
    Eigen::Matrix3d F;
    F.col(0) = first.normalized();
    F.col(2) = first.cross(second).normalized();
    F.col(1) = F.col(2).cross(F.col(0));
    return F;
  };
  Quaternion_vector<double> q(mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    const Eigen::Vector3d x = mesh.position(v[1]) - mesh.position(v[0]),
                          y = mesh.position(v[2]) - mesh.position(v[0]),
                          X = positions.col(v[1]) - positions.col(v[0]),
                          Y = positions.col(v[2]) - positions.col(v[0]);
    const Eigen::Matrix3d from = frame(x, y), to = frame(X, Y);
    // In these frames the linear map is [a c; 0 d].
    const double a = X.norm() / x.norm();
    const double d = to.col(1).dot(Y) / from.col(1).dot(y);
    const double c = (to.col(0).dot(Y) - a * from.col(0).dot(y)) / from.col(1).dot(y);
    const Eigen::AngleAxisd nearest(std::atan2(-c, a + d), Eigen::Vector3d::UnitZ());
    q[f] = spin_of(Eigen::Matrix3d(to * nearest * from.transpose()), std::sqrt(a * d));
  }
  return q;
}

/// \ingroup PkgSpin
/// \brief chooses the signs of face spins such that they agree with those of their neighbours along
/// a spanning tree of the faces.
///
/// Without, the mean over the faces at a vertex would be of arbitrary signs as soon as rotations
/// exceed half a turn.
/// \returns how many edges have opposite signs on their sides: of a deformation that is smooth at
/// the scale of the faces none, unless it is of another spin structure
inline int make_consistent(const Mesh_view& mesh, Quaternion_vector<double>& spins)
{
  std::vector<char> is_met(static_cast<std::size_t>(mesh.size_of_faces()), 0);
  std::vector<int> queue = {0};
  is_met[0] = 1;
  const auto for_each_neighbour = [&](int f, auto visit) {
    for (int h = 3 * f; h < 3 * f + 3; ++h)
      if (mesh.twin(h) >= 0) visit(Mesh_view::face(mesh.twin(h)));
  };
  for (std::size_t i = 0; i < queue.size(); ++i)
    for_each_neighbour(queue[i], [&, f = queue[i]](int g) {
      if (is_met[static_cast<std::size_t>(g)]) return;
      is_met[static_cast<std::size_t>(g)] = 1;
      if (dot(spins[f], spins[g]) < 0) spins[g] *= -1;
      queue.push_back(g);
    });
  int conflicts = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for_each_neighbour(f, [&](int g) { conflicts += f < g && dot(spins[f], spins[g]) < 0; });
  return conflicts;
}

/// \ingroup PkgSpin
/// the mean of the faces around each vertex, weighted by area, |V|
inline Quaternion_vector<double> vertex_spins(const Mesh_view& mesh,
                                              const Quaternion_vector<double>& face_spins)
{
  const Eigen::VectorXd areas = face_areas(mesh), vertex_area = vertex_areas(mesh);
  Quaternion_vector<double> mu = Quaternion_vector<double>::Constant(mesh.size_of_vertices(), {});
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (int v : mesh.corners(f)) mu[v] += face_spins[f] * (areas[f] / 3 / vertex_area[v]);
  return mu;
}

}  // namespace Conformal_geometry_processing

#endif
