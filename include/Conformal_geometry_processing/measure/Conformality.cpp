// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/measure/Conformality.h>

#include <Conformal_geometry_processing/mesh/Normalized_frame.h>

#include <Eigen/Core>

#include <ostream>

namespace Conformal_geometry_processing {

// Comparisons are such that NaN is beyond every limit.
Conformality::Fault Conformality::fault(const Limits& limits) const
{
  for (const double Q : {quasi_conformal.mean, quasi_conformal_of_new_area})
    if (!(Q <= limits.quasi_conformal)) return Fault::not_conformal;
  if (!(flipped_share <= limits.flipped_share)) return Fault::flipped;
  if (!(scale.collapsed_share <= limits.collapsed_share)) return Fault::collapsed;
  return Fault::none;
}

const char* to_string(Conformality::Fault fault)
{
  switch (fault) {
    case Conformality::Fault::not_conformal:
      return "the map is not conformal";
    case Conformality::Fault::flipped:
      return "too many faces are flipped";
    case Conformality::Fault::collapsed:
      return "too much of the surface has collapsed";
    case Conformality::Fault::none:
      break;
  }
  return "none";
}

namespace internal {

Conformality measured_conformality(const Mesh_view& mesh, const Points& positions,
                                   const Points& expected_normals, const Surface_part& part)
{
  const Face_maps maps(mesh, positions, part);
  const Eigen::Vector3d sums =
      part.sum(Eigen::Vector3d(maps.quasi_conformal.dot(maps.new_areas), maps.new_areas.sum(),
                               static_cast<double>(maps.areas.size())));
  Conformality c;
  c.quasi_conformal = distribution(maps.quasi_conformal, maps.areas, part);
  c.quasi_conformal_of_new_area = sums[0] / sums[1];
  c.length_cross_ratio = length_cross_ratio_change(mesh, positions, part);
  c.scale = area_distortion(maps, part);
  c.flipped_faces = flipped_faces(mesh, positions, expected_normals, part);
  c.flipped_share = c.flipped_faces / sums[2];
  return c;
}

void print_conformality(std::ostream& out, const Conformality& c)
{
  out << "quasi-conformal error  " << c.quasi_conformal.mean << " mean, " << c.quasi_conformal.p99
      << " for 99 %, " << c.quasi_conformal.max << " at most (1 is conformal)\n"
      << "length cross-ratios    changed by " << c.length_cross_ratio.rms << " rms, "
      << c.length_cross_ratio.max << " at most (0 is conformal)\n"
      << "lengths                scaled by " << c.scale.min_scale << " to " << c.scale.max_scale
      << "\nflipped faces          " << c.flipped_faces << '\n';
}

}  // namespace internal

Conformality conformality(const Mesh_view& mesh, const Points& positions,
                          const Points& expected_normals)
{
  const internal::Normalized_frame frame(mesh.positions());
  const bool is_moderate = frame.unit() > 1e-60 && frame.unit() < 1e60;
  if (is_moderate) return internal::measured_conformality(mesh, positions, expected_normals);
  Mesh_view in_frame = mesh;
  in_frame.set_positions(frame.to_frame(mesh.positions()));
  return internal::measured_conformality(in_frame, frame.to_frame(positions),
                                         expected_normals / expected_normals.cwiseAbs().maxCoeff());
}

}  // namespace Conformal_geometry_processing
