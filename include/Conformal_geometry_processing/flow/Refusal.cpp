// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Refusal.h>

#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/operators/mean_curvature.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>

namespace Conformal_geometry_processing::internal {

inline Eigen::VectorXd largest_at_vertices(const Mesh_view& mesh, const Eigen::VectorXd& of_faces)
{
  Eigen::VectorXd largest = Eigen::VectorXd::Constant(mesh.size_of_vertices(), -HUGE_VAL);
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (const int v : mesh.corners(f))
      if (!(of_faces[f] <= largest[v])) largest[v] = of_faces[f];
  return largest;
}

/// how far the normals of faces are from those expected, times their areas: positive if flipped
inline Eigen::VectorXd turned_areas(const Mesh_view& mesh, const Points& positions)
{
  const Mesh_view after(positions, mesh.corners());
  const Points expected = neighbourhood_normals(mesh, positions);
  Eigen::VectorXd turned(mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const Eigen::Vector3d normal = after.vector(3 * f).cross(after.vector(3 * f + 1));
    const Eigen::Vector3d wanted = expected.col(f);
    turned[f] = -normal.dot(wanted) / (std::max)(wanted.norm(), 1e-300);
  }
  return turned;
}

inline std::string exceeds(const char* what, double value, double limit)
{
  std::ostringstream text;
  text.precision(6);
  text << what << ' ' << value << ", more than " << limit;
  return text.str();
}

Refusal beyond_limits(const Mesh_view& mesh, const Points& positions, const Conformality& map,
                      const Conformality::Limits& limits)
{
  switch (map.fault(limits)) {
    case Conformality::Fault::not_conformal:
      return {exceeds("the mean quasi-conformal error is",
                      (std::max)(map.quasi_conformal.mean, map.quasi_conformal_of_new_area),
                      limits.quasi_conformal),
              distortion_at_vertices(mesh, positions)};
    case Conformality::Fault::flipped:
      return {exceeds("the share of flipped faces is", map.flipped_share, limits.flipped_share),
              largest_at_vertices(mesh, turned_areas(mesh, positions))};
    case Conformality::Fault::collapsed:
      return {exceeds("the share of the area that has collapsed is", map.scale.collapsed_share,
                      limits.collapsed_share),
              largest_at_vertices(mesh, -length_scales(mesh, positions))};
    case Conformality::Fault::none:
      break;
  }
  return {};
}

inline Eigen::VectorXd energy_of_vertices(const Mesh_view& mesh)
{
  return voronoi_areas(mesh).cwiseProduct(mean_curvature(mesh).cwiseAbs2());
}

Eigen::VectorXd energy_growth(const Mesh_view& before, const Mesh_view& after)
{
  return energy_of_vertices(after) - energy_of_vertices(before);
}

Eigen::VectorXd distortion_at_vertices(const Mesh_view& mesh, const Points& positions)
{
  return largest_at_vertices(mesh, quasi_conformal_errors(mesh, positions));
}

Eigen::VectorXd misfit_of_class(const Mesh_view& mesh, const Points& positions)
{
  const Eigen::VectorXd change =
      log_length_cross_ratios(mesh, positions) - log_length_cross_ratios(mesh, mesh.positions());
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    for (const int v : mesh.ends(k))
      if (!(std::abs(change[k]) <= largest[v])) largest[v] = std::abs(change[k]);
  return largest;
}

/// of the corners of a face, in radians
inline double least_angle(const Mesh_view& mesh, int face)
{
  const Sheet& sheet = mesh.sheet(face);
  return (std::min)({corner_angle(sheet, 0), corner_angle(sheet, 1), corner_angle(sheet, 2)});
}

Eigen::VectorXd thinness(const Mesh_view& mesh)
{
  Eigen::VectorXd least(mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) least[f] = -least_angle(mesh, f);
  return largest_at_vertices(mesh, least);
}

Flow_step_report::Place place_of(const Mesh_view& input, const Eigen::VectorXd& measure)
{
  Flow_step_report::Place place;
  const auto badness = [&](int v) { return std::isnan(measure[v]) ? HUGE_VAL : measure[v]; };
  for (int v = 0; v < measure.size(); ++v)
    if (place.vertex < 0 || badness(v) > badness(place.vertex)) place.vertex = v;
  for (int f = 0; f < input.size_of_faces(); ++f) {
    const auto& corners = input.corners(f);
    if (std::find(corners.begin(), corners.end(), place.vertex) == corners.end()) continue;
    const double angle = least_angle(input, f);
    if (place.face < 0 || angle < place.angle) place.face = f, place.angle = angle;
  }
  return place;
}

}  // namespace Conformal_geometry_processing::internal
