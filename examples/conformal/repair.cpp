// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "repair.h"

#include "Corner_fans.h"
#include "Table.h"
#include "merge_points.h"
#include "orientation.h"
#include "triangulation.h"

#include "io/select_rows.h"
#include "io/texture_coordinates.h"

#include <algorithm>
#include <set>

namespace conformal {
namespace {

std::size_t at(int i)
{
  return static_cast<std::size_t>(i);
}

/// The corners of one face as places in the file; those that repeat the one before are left out.
std::vector<int> distinct_corners(const Polygons& polygons, std::size_t f)
{
  std::vector<int> places;
  for (std::size_t c = polygons.first[f]; c < polygons.first[f + 1]; ++c)
    if (places.empty() || polygons.corners[at(places.back())] != polygons.corners[c])
      places.push_back(static_cast<int>(c));
  while (places.size() > 1 &&
         polygons.corners[at(places.back())] == polygons.corners[at(places.front())])
    places.pop_back();
  return places;
}

/// Faces to be kept, as places of their corners in the file: not degenerate, and each once.
struct Kept_faces {
  std::vector<int> face_in_file;
  std::vector<std::vector<int>> places;
};

Kept_faces keep_faces(const Polygons& polygons)
{
  Kept_faces kept;
  std::set<std::vector<int>> known;
  for (std::size_t f = 0; f < polygons.size(); ++f) {
    std::vector<int> places = distinct_corners(polygons, f), vertices;
    for (const int c : places) vertices.push_back(polygons.corners[at(c)]);
    std::sort(vertices.begin(), vertices.end());
    const bool is_repeated = std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end();
    if (vertices.size() < 3 || is_repeated || !known.insert(std::move(vertices)).second) continue;
    kept.face_in_file.push_back(static_cast<int>(f));
    kept.places.push_back(std::move(places));
  }
  return kept;
}

/// Rebuilds faces and all that belongs to them or their corners.
void select_faces(Surface_file& file, const Kept_faces& kept)
{
  Polygons polygons;
  std::vector<int> texture, normals;
  for (const std::vector<int>& places : kept.places) {
    for (const int c : places) {
      polygons.corners.push_back(file.polygons.corners[at(c)]);
      if (!file.texture.index.empty()) texture.push_back(file.texture.index[at(c)]);
      if (!file.normals.index.empty()) normals.push_back(file.normals.index[at(c)]);
    }
    polygons.first.push_back(polygons.corners.size());
  }
  for (Group_line& line : file.group_lines)
    line.face = static_cast<std::size_t>(std::lower_bound(kept.face_in_file.begin(),
                                                          kept.face_in_file.end(),
                                                          static_cast<int>(line.face)) -
                                         kept.face_in_file.begin());
  file.polygons = std::move(polygons);
  file.texture.index = std::move(texture);
  file.normals.index = std::move(normals);
  file.faces = selected_rows(file.faces, kept.face_in_file);
}

/// Where the vertices of the repaired file were, the copies last.
struct Separated_vertices {
  std::vector<int> vertex_in_file;
  int copies = 0;
};

/// Gives every fan of corners a vertex of its own: the first fan of a vertex has its place.
Separated_vertices separate_fans(Surface_file& file, const Corner_fans& fans)
{
  std::vector<int>& corners = file.polygons.corners;
  std::vector<int> fan_of_vertex(file.points.size(), -1), copied;
  std::vector<int> vertex_of_fan(at(fans.size()), -1), number(at(fans.size()), -1);
  for (std::size_t c = 0; c < corners.size(); ++c) {
    const int fan = fans.of_corner(c);
    if (vertex_of_fan[at(fan)] >= 0) continue;
    vertex_of_fan[at(fan)] = corners[c];
    if (fan_of_vertex[at(corners[c])] < 0)
      fan_of_vertex[at(corners[c])] = fan;
    else
      copied.push_back(fan);
  }
  Separated_vertices separated;
  const auto number_next = [&](int fan) {
    number[at(fan)] = static_cast<int>(separated.vertex_in_file.size());
    separated.vertex_in_file.push_back(vertex_of_fan[at(fan)]);
  };
  for (const int fan : fan_of_vertex)
    if (fan >= 0) number_next(fan);
  for (const int fan : copied) number_next(fan);
  separated.copies = static_cast<int>(copied.size());
  for (std::size_t c = 0; c < corners.size(); ++c) corners[c] = number[at(fans.of_corner(c))];
  return separated;
}

void select_vertices(Surface_file& file, const std::vector<int>& kept)
{
  std::vector<Point> points;
  for (const int v : kept) points.push_back(file.points[at(v)]);
  file.points = std::move(points);
  file.vertices = selected_rows(file.vertices, kept);
}

std::vector<int> inverse(const std::vector<int>& where_it_was, std::size_t size)
{
  std::vector<int> where_it_is(size, -1);
  for (std::size_t i = where_it_was.size(); i-- > 0;)  // of copies the first one counts
    where_it_is[at(where_it_was[i])] = static_cast<int>(i);
  return where_it_is;
}

bool is_counting(const std::vector<int>& numbers, std::size_t size)
{
  if (numbers.size() != size) return false;
  for (std::size_t i = 0; i < size; ++i)
    if (numbers[i] != static_cast<int>(i)) return false;
  return true;
}

/// \returns how many faces were turned around
int orient(Surface_file& file)
{
  const auto [corners, face_in_file, triangulated] = triangulate(file);
  Conformal_geometry_processing::Points nowhere =
      Conformal_geometry_processing::Points::Zero(3, static_cast<Eigen::Index>(file.points.size()));
  const Conformal_geometry_processing::Mesh_view mesh(std::move(nowhere), corners);
  const Orientation o = find_orientation(mesh, face_in_file, file.polygons.size());
  turn_faces(file, o.is_turned);
  return static_cast<int>(std::count(o.is_turned.begin(), o.is_turned.end(), 1));
}

// They may name vertices by numbers that are no longer theirs.
void leave_out_other_elements(Surface_file& file)
{
  for (const Element& element : file.other_elements)
    file.notes.push_back("elements of the kind '" + element.name +
                         "' left out: the vertices have new numbers");
  file.other_elements.clear();
}

}  // namespace

bool Repair::has_changed_anything() const
{
  return merged_points + removed_faces + turned_faces + cut_edges + added_vertices +
             removed_vertices >
         0;
}

std::vector<std::string> Repair::notes() const
{
  std::vector<std::string> notes;
  const auto tell = [&](int count, const char* noun, const char* what) {
    if (count > 0)
      notes.push_back("repaired: " + count_of(static_cast<std::size_t>(count), noun) + what);
  };
  tell(merged_points, "vertex", " merged into others at the same place");
  tell(removed_faces, "face", " removed: repeated, or with fewer than three different corners");
  tell(turned_faces, "face", " turned around, to agree with the others");
  tell(cut_edges, "edge", " cut open where more than two faces met, or two could not agree");
  tell(added_vertices, "vertex", " added where fans of faces only touched");
  tell(removed_vertices, "vertex", " without a face removed");
  return notes;
}

Repair repair(Surface_file& file)
{
  Repair done;
  const std::size_t points = file.points.size(), faces = file.polygons.size();
  const std::vector<int> merged = merge_points(file.points);
  if (is_counting(merged, points))
    list_to_corners(file);
  else if (Corner_values texture = texture_coordinates(file); !texture.empty())
    set_texture_coordinates(file, std::move(texture));  // points of a seam may be one now
  for (int& v : file.polygons.corners) v = merged[at(v)];

  const Kept_faces kept = keep_faces(file.polygons);
  done.face_in_file = kept.face_in_file;
  done.removed_faces = static_cast<int>(faces - kept.face_in_file.size());
  select_faces(file, kept);
  done.turned_faces = orient(file);

  const Corner_fans fans(file.polygons);
  done.cut_edges = fans.size_of_cut_edges();
  Separated_vertices separated = separate_fans(file, fans);
  done.added_vertices = separated.copies;
  done.vertex_in_file = std::move(separated.vertex_in_file);
  if (!is_counting(done.vertex_in_file, points)) leave_out_other_elements(file);
  select_vertices(file, done.vertex_in_file);

  done.new_face = inverse(done.face_in_file, faces);
  done.new_vertex = inverse(done.vertex_in_file, points);
  for (std::size_t v = 0; v < points; ++v) {
    const bool is_merged = merged[v] != static_cast<int>(v);
    done.merged_points += is_merged;
    done.removed_vertices += !is_merged && done.new_vertex[v] < 0;
    if (is_merged) done.new_vertex[v] = done.new_vertex[at(merged[v])];
  }
  return done;
}

}  // namespace conformal
