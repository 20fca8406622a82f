// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "filter_rho.h"
#include "rho.h"

#include "conformal/io/data/texture_coordinates.h"
#include "conformal/io/read_gray_image.h"
#include "conformal/process/Failure.h"

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/painting/image_filters.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace conformal {
namespace {

using Coordinates = Eigen::Vector2d;

// Where a point of the unit box [-1, 1]^3, or a direction, falls on the picture.
Coordinates projected(const Eigen::Vector3d& p, Projection projection)
{
  const double pi = std::acos(-1.);
  switch (projection) {
    case Projection::x:
      return {(p.y() + 1) / 2, (p.z() + 1) / 2};
    case Projection::y:
      return {(p.x() + 1) / 2, (p.z() + 1) / 2};
    case Projection::z:
      return {(p.x() + 1) / 2, (p.y() + 1) / 2};
    default:
      return {std::atan2(p.y(), p.x()) / (2 * pi) + 0.5,
              std::atan2(p.z(), std::hypot(p.x(), p.y())) / pi + 0.5};
  }
}

// The bounding box onto [-1, 1]^3, so that a picture covers the surface; a sphere projection keeps
// directions.
CGP::Points in_box(const CGP::Mesh_view& mesh, Projection projection)
{
  const User_frame frame(mesh);
  CGP::Points points(3, mesh.size_of_vertices());
  for (int v = 0; v < mesh.size_of_vertices(); ++v) points.col(v) = frame(mesh.position(v));
  if (projection == Projection::sphere) return points;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double half = points.row(i).cwiseAbs().maxCoeff();
    if (half > 0) points.row(i) /= half;
  }
  return points;
}

/// of the vertices, or of the middles of the faces
Eigen::Matrix2Xd places_by_projection(const Surface_input& input, const Rho_options& options)
{
  CGP::Points points = in_box(input.mesh, options.projection);
  if (options.on_faces.value_or(false)) points = CGP::means_of_corners(input.mesh, points);
  Eigen::Matrix2Xd places(2, points.cols());
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    places.col(i) = projected(points.col(i), options.projection);
  return places;
}

/// the texture coordinates of a vertex of a face, which may have others in its other faces; no
/// numbers where it has none
Coordinates place_in_texture(const Surface_input& input, const Corner_values& texture, int f, int v)
{
  const Polygons& polygons = input.file.polygons;
  const auto face = static_cast<std::size_t>(input.face_in_file[static_cast<std::size_t>(f)]);
  const int vertex = input.vertex_in_file[static_cast<std::size_t>(v)];
  const auto all = polygons.corners.begin();
  const auto corner =
      std::find(all + static_cast<std::ptrdiff_t>(polygons.first[face]),
                all + static_cast<std::ptrdiff_t>(polygons.first[face + 1]), vertex);
  const int row = texture.index[static_cast<std::size_t>(corner - all)];
  if (row < 0) return Coordinates::Constant(std::numeric_limits<double>::quiet_NaN());
  const auto& uv = texture.values[static_cast<std::size_t>(row)];
  return {uv[0], uv[1]};
}

Eigen::VectorXd gray_of_faces(const Surface_input& input, const Corner_values& texture,
                              const CGP::Gray_image& image)
{
  Eigen::Matrix2Xd places = Eigen::Matrix2Xd::Zero(2, input.mesh.size_of_faces());
  for (int f = 0; f < input.mesh.size_of_faces(); ++f)
    for (const int v : input.mesh.corners(f))
      places.col(f) += place_in_texture(input, texture, f, v) / 3;
  return image(places);
}

// The mean over the corners at each vertex, which may have different coordinates at a seam.
Eigen::VectorXd gray_of_vertices(const Surface_input& input, const Corner_values& texture,
                                 const CGP::Gray_image& image)
{
  const Surface_file& file = input.file;
  std::vector<double> sum(file.points.size(), 0), count(sum);
  for (std::size_t c = 0; c < texture.index.size(); ++c) {
    if (texture.index[c] < 0) continue;
    const auto& uv = texture.values[static_cast<std::size_t>(texture.index[c])];
    const auto v = static_cast<std::size_t>(file.polygons.corners[c]);
    sum[v] += image(uv[0], uv[1]);
    count[v] += 1;
  }
  Eigen::VectorXd gray(input.mesh.size_of_vertices());
  for (int v = 0; v < gray.size(); ++v) {
    const auto i = static_cast<std::size_t>(input.vertex_in_file[static_cast<std::size_t>(v)]);
    gray[v] = sum[i] / count[i];  // no number where a vertex has no coordinates: refused later
  }
  return gray;
}

Eigen::VectorXd gray_from_texture(const Surface_input& input, const CGP::Gray_image& image,
                                  bool on_faces)
{
  const Corner_values texture = texture_coordinates(input.file);
  if (texture.index.empty())
    throw unsuitable(input.file.path,
                     "has no texture coordinates for --paint; try: --projection sphere, or x, y, "
                     "z");
  return on_faces ? gray_of_faces(input, texture, image) : gray_of_vertices(input, texture, image);
}

}  // namespace

CGP::Curvature_potential rho_from_image(const Surface_input& input, const Rho_options& options)
{
  const CGP::Gray_image image = filtered(read_gray_image(options.image), options);
  const bool on_faces = options.on_faces.value_or(false);
  const Eigen::VectorXd gray = options.projection == Projection::uv
                                   ? gray_from_texture(input, image, on_faces)
                                   : image(places_by_projection(input, options));
  const double middle_gray = 0.5;
  const Eigen::VectorXd rho = gray.array() - middle_gray;
  return on_faces ? CGP::Curvature_potential::on_faces(rho)
                  : CGP::Curvature_potential::on_vertices(rho);
}

}  // namespace conformal
