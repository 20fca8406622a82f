// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/Enclosure.h>

#include <Conformal_geometry_processing/mesh/Normalized_frame.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>

namespace Conformal_geometry_processing {

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
