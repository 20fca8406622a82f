// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "keep_exhibit.h"

#include "conformal_charts.h"

#include "conformal/io/data/texture_coordinates.h"

#include <Conformal_geometry_processing/mesh/Normalized_frame.h>

#include <utility>

namespace conformal {
namespace {

/// the place of a vertex in a polygon of the file, as an index of `Polygons::corners`
std::size_t corner_in_file(const Polygons& polygons, int face, int vertex)
{
  std::size_t corner = polygons.first[static_cast<std::size_t>(face)];
  while (polygons.corners[corner] != vertex) ++corner;
  return corner;
}

/// the texture coordinates of the file at the corners of the triangles; none if a corner has none
Corner_places places_in_file(const Surface_input& input)
{
  const Corner_values texture = texture_coordinates(input.file);
  if (texture.empty()) return {};
  Corner_places places;
  for (int f = 0; f < input.mesh.size_of_faces(); ++f)
    for (const int v : input.mesh.corners(f)) {
      const std::size_t corner =
          corner_in_file(input.file.polygons, input.face_in_file[static_cast<std::size_t>(f)],
                         input.vertex_in_file[static_cast<std::size_t>(v)]);
      const int row = texture.index[corner];
      if (row < 0) return {};
      const std::array<double, 3>& value = texture.values[static_cast<std::size_t>(row)];
      places.push_back({value[0], value[1]});
    }
  return places;
}

Corner_places places_in_plane(const CGP::Mesh_view& mesh, const CGP::Points& positions)
{
  Corner_places places;
  for (const auto& corners : mesh.corners())
    for (const int v : corners) places.push_back({positions(0, v), positions(1, v)});
  return places;
}

/// both shapes in frames of their own, in which a float has room for them; no squares yet
Exhibit shapes(const CGP::Mesh_view& before, const CGP::Points& after)
{
  const auto framed = [](const CGP::Points& p) {
    return CGP::internal::Normalized_frame(p).to_frame(p);
  };
  Exhibit exhibit{before, framed(after), {}, {}};
  exhibit.before.set_positions(framed(before.positions()));
  return exhibit;
}

void keep(Exhibit exhibit, Session& session)
{
  session.outcome().exhibit = std::move(exhibit);
  session.end_stage("html");
}

}  // namespace

void keep_exhibit(const Surface_input& before, const CGP::Points& after, Session& session)
{
  if (session.options().html.empty()) return;
  Exhibit exhibit = shapes(before.mesh, after);
  exhibit.squares = places_in_file(before);
  exhibit.kind_of_squares = "the input's texture coordinates";
  if (exhibit.squares.empty()) {
    exhibit.squares = conformal_charts(exhibit.before);
    exhibit.kind_of_squares = "conformal maps of the input to the plane";
  }
  keep(std::move(exhibit), session);
}

void keep_flat_exhibit(const Surface_input& before, const CGP::Points& after, Session& session)
{
  if (session.options().html.empty()) return;
  Exhibit exhibit = shapes(before.mesh, after);
  exhibit.squares = places_in_plane(exhibit.before, exhibit.after);
  exhibit.kind_of_squares = "the plane";
  keep(std::move(exhibit), session);
}

}  // namespace conformal
