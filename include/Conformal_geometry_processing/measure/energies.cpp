// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/energies.h>

#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>

namespace Conformal_geometry_processing {

double total_area(const Mesh_view& mesh)
{
  return face_areas(mesh).sum();
}

double signed_volume(const Mesh_view& mesh)
{
  // Relative to a point of the surface, to avoid cancellation if the origin is far away.
  const Eigen::Vector3d o = mesh.position(0);
  double volume = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    volume += mesh.double_area_vector(f).dot(mesh.position(mesh.corners(f)[0]) - o) / 6;
  return volume;
}

Eigen::VectorXd bending_angles(const Mesh_view& mesh)
{
  const Points N = face_normals(mesh);
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(mesh.size_of_edges());
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    const int h = mesh.halfedges_begin(k)[0], g = mesh.twin(h);
    if (g < 0) continue;
    const Eigen::Vector3d left = N.col(Mesh_view::face(h)), right = N.col(Mesh_view::face(g));
    // From the left to the right face of a convex edge, the normal rotates by a positive angle
    // about the direction of the edge.
    angles[k] =
        std::atan2(left.cross(right).dot(stable_normalized(mesh.vector(h))), left.dot(right));
  }
  return angles;
}

double willmore_energy(const Surface_ref& surface)
{
  return voronoi_areas(surface).dot(mean_curvature(surface).cwiseAbs2());
}

double steiner_willmore_energy(const Mesh_view& mesh)
{
  const Eigen::VectorXd angles = bending_angles(mesh), areas = vertex_areas(mesh);
  Eigen::VectorXd integral = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    for (int v : mesh.ends(k))
      integral[v] += angles[k] * mesh.vector(mesh.halfedges_begin(k)[0]).norm() / 4;
  return integral.cwiseAbs2().cwiseQuotient(areas).sum();
}

Enclosure enclosure(const Mesh_view& mesh)
{
  const internal::Normalized_frame frame(mesh.positions());
  const internal::Enclosure_gradient g(mesh, frame.to_frame(mesh.positions()));
  const double unit = frame.unit();
  return {g.area * unit * unit, g.volume * std::pow(unit, 3), g.reduced_volume()};
}

internal::Enclosure_gradient::Enclosure_gradient(const Mesh_view& mesh, const Points& f)
    : of_area(Points::Zero(3, f.cols())), of_volume(of_area)
{
  for (int k = 0; k < mesh.size_of_faces(); ++k) {
    const Eigen::Vector3d normal = mesh.double_area_vector(k, f);
    const double size = normal.norm();
    if (!(size > 0)) continue;
    const auto& v = mesh.corners(k);
    area += size / 2;
    volume += normal.dot(f.col(v[0]) - f.col(0)) / 6;
    for (std::size_t c = 0; c < 3; ++c) {
      const Eigen::Vector3d opposite = f.col(v[(c + 2) % 3]) - f.col(v[(c + 1) % 3]);
      of_area.col(v[c]) += normal.cross(opposite) / (2 * size);
      of_volume.col(v[c]) += normal / 6;
    }
  }
}

double internal::Enclosure_gradient::reduced_volume() const
{
  const double pi = 3.14159265358979323846;
  return 6 * std::sqrt(pi) * volume / std::pow(area, 1.5);
}

Points internal::Enclosure_gradient::of_log_reduced_volume() const
{
  return of_volume / volume - 1.5 / area * of_area;
}

}  // namespace Conformal_geometry_processing
