// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/face_spins.h>

#include <Conformal_geometry_processing/algebra/rotor.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {

Quaternion_vector<double> face_spins(const Mesh_view& mesh, const Points& positions)
{
  // Frame with T along the first edge of the face and N its normal; and coordinates of the third
  // corner.
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

namespace internal {

bool is_thin(const Mesh_view& mesh, int f)
{
  const Eigen::Matrix3d e = mesh.sheet(f).vectors;
  return !(mesh.double_area_vector(f).norm() > 1e-3 * e.colwise().squaredNorm().maxCoeff());
}

}  // namespace internal

void replace_thin_faces(const Mesh_view& mesh, const Points& positions,
                        Quaternion_vector<double>& spins)
{
  const Mesh_view moved(positions, mesh.corners());
  std::vector<int> thin;
  std::vector<char> is_known(static_cast<std::size_t>(mesh.size_of_faces()), 1);
  const auto known = [&](int f) -> char& { return is_known[static_cast<std::size_t>(f)]; };
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    if (internal::is_thin(mesh, f) || internal::is_thin(moved, f)) thin.push_back(f), known(f) = 0;
  for (bool has_changed = true; has_changed;) {
    std::vector<int> rest, done;
    for (const int f : thin) {
      Quaternion<double> sum;
      int count = 0;
      for (int h = 3 * f; h < 3 * f + 3; ++h)
        if (const int t = mesh.twin(h); t >= 0 && known(Mesh_view::face(t))) {
          const Quaternion<double> q = spins[Mesh_view::face(t)];
          sum += dot(sum, q) < 0 ? q * -1. : q;
          ++count;
        }
      (count > 0 ? done : rest).push_back(f);
      if (count > 0) spins[f] = sum / count;
    }
    for (const int f : done) known(f) = 1;
    has_changed = !done.empty();
    thin = std::move(rest);
  }
}

int make_consistent(const Mesh_view& mesh, Quaternion_vector<double>& spins)
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

Quaternion_vector<double> vertex_spins(const Mesh_view& mesh,
                                       const Quaternion_vector<double>& face_spins)
{
  const Eigen::VectorXd areas = curvature_areas(mesh, Curvature_potential::On::faces);
  Eigen::VectorXd vertex_area = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (int v : mesh.corners(f)) vertex_area[v] += areas[f] / 3;
  Quaternion_vector<double> mu = Quaternion_vector<double>::Constant(mesh.size_of_vertices(), {});
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (int v : mesh.corners(f)) mu[v] += face_spins[f] * (areas[f] / 3 / vertex_area[v]);
  return mu;
}

}  // namespace Conformal_geometry_processing
