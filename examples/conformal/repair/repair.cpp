// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "repair.h"

#include "Corner_fans.h"
#include "mend_flat_faces.h"
#include "orientation.h"
#include "select_faces.h"
#include "separate_fans.h"
#include "triangulation.h"

#include "conformal/io/data/texture_coordinates.h"
#include "conformal/process/Failure.h"
#include "conformal/process/at.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace conformal {
namespace {

/// \brief For each point the first one with exactly the same coordinates, which may be itself.
std::vector<int> merge_points(const std::vector<Point>& points)
{
  const auto point = [&](int i) -> const Point& { return points[static_cast<std::size_t>(i)]; };
  std::vector<int> order(points.size()), first(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return point(i) < point(j); });
  for (std::size_t k = 0; k < order.size(); ++k) {
    const bool is_new = k == 0 || point(order[k]) != point(order[k - 1]);
    first[static_cast<std::size_t>(order[k])] =
        is_new ? order[k] : first[static_cast<std::size_t>(order[k - 1])];
  }
  return first;
}

/// The corners of one face as places in the file; those that repeat the one before are left out.
std::vector<std::size_t> distinct_corners(const Polygons& polygons, std::size_t f)
{
  const std::vector<int>& corners = polygons.corners;
  std::vector<std::size_t> places;
  for (std::size_t c = polygons.first[f]; c < polygons.first[f + 1]; ++c)
    if (places.empty() || corners[places.back()] != corners[c]) places.push_back(c);
  while (places.size() > 1 && corners[places.back()] == corners[places.front()]) places.pop_back();
  return places;
}

/// The faces to be kept: not degenerate, and each once.
class Face_filter {
 public:
  explicit Face_filter(const Surface_file& file) : m_file(file) {}

  /// \param corners without repetitions in a row
  void add(std::size_t f, const std::vector<std::size_t>& corners, Repair& done)
  {
    const std::vector<int> vertices = vertices_of(corners);
    const bool has_bridge = std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end();
    bool is_kept = false;
    for (const std::vector<std::size_t>& part : parts_of(corners, has_bridge))
      is_kept = keep(f, part) || is_kept;
    done.removed_faces += !is_kept;
    done.bridged_faces += is_kept && has_bridge;
    done.shortened_faces += is_kept && !has_bridge && corners.size() < m_file.polygons.degree(f);
  }

  Selected_faces take() { return std::move(m_kept); }

 private:
  std::vector<int> vertices_of(const std::vector<std::size_t>& corners) const
  {
    std::vector<int> vertices;
    for (const std::size_t c : corners) vertices.push_back(m_file.polygons.corners[c]);
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  }

  std::vector<std::vector<std::size_t>> parts_of(const std::vector<std::size_t>& corners,
                                                 bool has_bridge) const
  {
    if (!has_bridge) return {corners};
    std::vector<std::vector<std::size_t>> parts;
    for (const auto& t : triangles_of(m_file, corners)) parts.push_back({t[0], t[1], t[2]});
    return parts;
  }

  bool keep(std::size_t f, const std::vector<std::size_t>& corners)
  {
    std::vector<int> vertices = vertices_of(corners);
    const bool is_degenerate =
        vertices.size() < 3 ||
        std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end();
    if (is_degenerate || !m_known.insert(std::move(vertices)).second) return false;
    append(m_kept, m_file, static_cast<int>(f), corners);
    return true;
  }

  const Surface_file& m_file;
  Selected_faces m_kept;
  std::set<std::vector<int>> m_known;
};

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

/// \returns the number of reversed faces
int orient(Surface_file& file)
{
  const Triangulation all = triangulate(file);
  Conformal_geometry_processing::Points nowhere =
      Conformal_geometry_processing::Points::Zero(3, static_cast<Eigen::Index>(file.points.size()));
  const Conformal_geometry_processing::Mesh_view mesh(std::move(nowhere), all.corners);
  const Orientation o = find_orientation(mesh, all.face_in_file, file.polygons.size());
  turn_faces(file, o.is_turned);
  return static_cast<int>(std::count(o.is_turned.begin(), o.is_turned.end(), 1));
}

// They may refer to vertices by outdated numbers.
void leave_out_other_elements(Surface_file& file)
{
  for (const Element& element : file.other_elements)
    file.notes.push_back("elements of the kind '" + element.name +
                         "' left out: the vertices have new numbers");
  file.other_elements.clear();
}

/// Replaces vertices of corners by the first vertex at the same point. \returns it for each vertex
std::vector<int> merge_vertices(Surface_file& file)
{
  std::vector<int> merged = merge_points(file.points);
  if (is_counting(merged, file.points.size()))
    list_to_corners(file);
  else if (Corner_values texture = texture_coordinates(file); !texture.empty())
    set_texture_coordinates(file, std::move(texture));  // points of a seam may be one now
  for (int& v : file.polygons.corners) v = merged[at(v)];
  return merged;
}

void remove_bad_faces(Surface_file& file, Repair& done)
{
  Face_filter filter(file);
  for (std::size_t f = 0; f < file.polygons.size(); ++f)
    filter.add(f, distinct_corners(file.polygons, f), done);
  Selected_faces kept = filter.take();
  done.face_in_file = kept.face_in_file;
  select_faces(file, std::move(kept));
}

/// \param merged into which vertex each one went; collapses are added
void mend(Surface_file& file, Repair& done, std::vector<int>& merged)
{
  Mended_faces mended = mend_flat_faces(file);
  done.flipped_edges = mended.flipped_edges;
  done.collapsed_edges = static_cast<int>(mended.collapsed.size());
  done.removed_flat_faces = static_cast<int>(mended.removed.size());
  done.cut_polygons = mended.cut_polygons;
  done.longest_collapsed_edge = mended.longest_collapsed;
  done.removed_triangles = std::move(mended.removed);
  for (int& f : mended.face_in_file) f = done.face_in_file[at(f)];
  done.face_in_file = std::move(mended.face_in_file);
  std::vector<int> into(file.points.size());
  std::iota(into.begin(), into.end(), 0);
  for (const auto& [from, to] : mended.collapsed) into[at(from)] = to;
  for (int& v : merged)
    while (into[at(v)] != v) v = into[at(v)];
}

void count_vertices(Repair& done, const std::vector<int>& merged)
{
  for (std::size_t v = 0; v < merged.size(); ++v) {
    const bool is_merged = merged[v] != static_cast<int>(v);
    done.merged_points += is_merged;
    done.removed_vertices += !is_merged && done.new_vertex[v] < 0;
    if (is_merged) done.new_vertex[v] = done.new_vertex[at(merged[v])];
  }
  done.merged_points -= done.collapsed_edges;
}

Repair repair_all(Surface_file& file)
{
  Repair done;
  const std::size_t points = file.points.size(), faces = file.polygons.size();
  std::vector<int> merged = merge_vertices(file);
  remove_bad_faces(file, done);
  done.turned_faces = orient(file);
  mend(file, done, merged);
  // Where three faces met, two may be left that are against each other; a one-sided surface is now
  // cut elsewhere.
  done.turned_faces += orient(file);

  const Corner_fans fans(file.polygons);
  done.cut_edges = fans.size_of_cut_edges();
  Separated_vertices separated = separate_fans(file, fans);
  done.added_vertices = separated.copies;
  done.vertex_in_file = std::move(separated.vertex_in_file);
  if (!is_counting(done.vertex_in_file, points)) leave_out_other_elements(file);

  done.new_face = inverse(done.face_in_file, faces);
  done.new_vertex = inverse(done.vertex_in_file, points);
  count_vertices(done, merged);
  return done;
}

}  // namespace

Repair repair(Surface_file& file)
{
  Surface_file repaired = file;
  Repair done = repair_all(repaired);
  if (repaired.polygons.size() == 0)
    throw unsuitable(file.path, "no face has an area, wanted a surface; try: another mesh");
  if (!done.has_changed_anything()) return done;
  done.before.path = file.path;
  done.before.format = file.format;
  done.before.points = std::move(file.points);
  done.before.polygons = std::move(file.polygons);
  file = std::move(repaired);
  return done;
}

}  // namespace conformal
