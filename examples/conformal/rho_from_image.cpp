// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "rho.h"

#include "Failure.h"
#include "Gray_image.h"
#include "Table.h"
#include "io/texture_coordinates.h"

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <cmath>

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

CGP::Curvature_potential from_projection(const Surface_input& input, const Gray_image& image,
                                         Projection projection)
{
  const CGP::Points points = in_box(input.mesh, projection);
  Eigen::VectorXd gray(points.cols());
  for (Eigen::Index v = 0; v < points.cols(); ++v) {
    const Coordinates uv = projected(points.col(v), projection);
    gray[v] = image(uv.x(), uv.y());
  }
  return CGP::Curvature_potential::on_vertices(std::move(gray));
}

// The mean over the corners at each vertex, which may have different coordinates at a seam.
CGP::Curvature_potential from_texture(const Surface_input& input, const Gray_image& image)
{
  const Surface_file& file = input.file;
  const Corner_values texture = texture_coordinates(file);
  if (texture.index.empty())
    throw unsuitable(file.path,
                     "has no texture coordinates for --rho-image; try: --projection sphere, or x, "
                     "y, z");
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
  return CGP::Curvature_potential::on_vertices(std::move(gray));
}

CGP::Curvature_potential on_faces(const CGP::Mesh_view& mesh, const Eigen::VectorXd& at_vertices)
{
  Eigen::VectorXd values(mesh.size_of_faces());
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const auto& v = mesh.corners(f);
    values[f] = (at_vertices[v[0]] + at_vertices[v[1]] + at_vertices[v[2]]) / 3;
  }
  return CGP::Curvature_potential::on_faces(std::move(values));
}

}  // namespace

CGP::Curvature_potential rho_from_image(const Surface_input& input, const Rho_options& options)
{
  const Gray_image image = read_gray_image(options.image);
  CGP::Curvature_potential rho = options.projection == Projection::uv
                                     ? from_texture(input, image)
                                     : from_projection(input, image, options.projection);
  const double middle_gray = 0.5;
  rho.values.array() -= middle_gray;
  return options.on_faces.value_or(false) ? on_faces(input.mesh, rho.values) : rho;
}

}  // namespace conformal
