// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Surface_input.h"

#include "conformal/io/read_surface.h"
#include "conformal/process/text.h"
#include "conformal/repair/orientation.h"
#include "conformal/repair/triangulation.h"

#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>

#include <numeric>
#include <set>

namespace conformal {
namespace {

// Renumbers the referenced vertices in order and updates the face indices.
std::vector<int> leave_out_unreferenced(std::size_t size, CGP::Mesh_view::Corners& corners)
{
  std::vector<int> number(size, -1);
  for (const auto& triangle : corners)
    for (const int v : triangle) number[static_cast<std::size_t>(v)] = 0;
  std::vector<int> kept;
  for (std::size_t v = 0; v < size; ++v)
    if (number[v] == 0) {
      number[v] = static_cast<int>(kept.size());
      kept.push_back(static_cast<int>(v));
    }
  for (auto& triangle : corners)
    for (int& v : triangle) v = number[static_cast<std::size_t>(v)];
  return kept;
}

// `2 vertices without a face (first: vertex 7): no part of the surface`
std::string note_of_unreferenced(int count, const std::vector<int>& others)
{
  int first = 0;
  for (const int v : others) first += v == first ? 1 : 0;
  return count_of(static_cast<std::size_t>(count), "vertex") + " without a face (first: vertex " +
         std::to_string(first) + "): no part of the surface";
}

CGP::Points points_of(const Surface_file& file, const std::vector<int>& vertices)
{
  CGP::Points points(3, static_cast<Eigen::Index>(vertices.size()));
  for (std::size_t i = 0; i < vertices.size(); ++i)
    points.col(static_cast<Eigen::Index>(i)) =
        Eigen::Vector3d::Map(file.points[static_cast<std::size_t>(vertices[i])].data());
  return points;
}

void turn(CGP::Mesh_view::Corners& corners, const std::vector<int>& face_in_file,
          const std::vector<char>& is_turned)
{
  for (std::size_t f = 0; f < corners.size(); ++f)
    if (is_turned[static_cast<std::size_t>(face_in_file[f])])
      std::swap(corners[f][1], corners[f][2]);
}

void repair_orientation(Surface_input& input)
{
  const Orientation o =
      find_orientation(input.mesh, input.face_in_file, input.file.polygons.size());
  input.is_orientable = o.is_orientable;
  input.turned_faces =
      static_cast<int>(std::accumulate(o.is_turned.begin(), o.is_turned.end(), 0L));
  if (!o.is_orientable || input.turned_faces == 0) return;
  auto corners = input.mesh.corners();
  turn(corners, input.face_in_file, o.is_turned);
  input.mesh = CGP::Mesh_view(input.mesh.positions(), std::move(corners));
  turn_faces(input.file, o.is_turned);
  input.notes.push_back(count_of(static_cast<std::size_t>(input.turned_faces), "face") + " of " +
                        std::to_string(input.file.polygons.size()) +
                        " turned around, to agree with the others");
}

bool is_closed_manifold(const CGP::Mesh_view& mesh)
{
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    if (mesh.halfedges_end(k) - mesh.halfedges_begin(k) != 2) return false;
  return mesh.size_of_faces() > 0;
}

void turn_outward(Surface_input& input)
{
  if (!input.is_orientable || !is_closed_manifold(input.mesh)) return;
  // The sign of the volume is right however large or small the surface is.
  if (!(CGP::signed_volume(CGP::internal::in_own_frame(input.mesh)) < 0)) return;
  input.is_turned_outward = true;
  auto corners = input.mesh.corners();
  for (auto& triangle : corners) std::swap(triangle[1], triangle[2]);
  input.mesh = CGP::Mesh_view(input.mesh.positions(), std::move(corners));
  input.notes.emplace_back(
      "the surface is inside out: computed with outward normals, faces are written as they were");
}

// As at seams of texture coordinates, where programs that have them at vertices cut a surface open.
int coinciding_at_boundary(const CGP::Mesh_view& mesh)
{
  std::set<int> boundary;
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    for (const int v : mesh.ends(k))
      if (mesh.halfedges_end(k) - mesh.halfedges_begin(k) == 1) boundary.insert(v);
  std::set<Point> points;
  for (const int v : boundary) {
    const Eigen::Vector3d p = mesh.position(v);
    points.insert({p.x(), p.y(), p.z()});
  }
  return static_cast<int>(boundary.size() - points.size());
}

// The index in the user's file, before its repair.
int before_repair(std::vector<int> Repair::*in_file, const Surface_input& input, int i)
{
  return input.repair ? ((*input.repair).*in_file)[static_cast<std::size_t>(i)] : i;
}

std::string with_obj_number(const Surface_input& input, const char* what, int i)
{
  std::string name = what + (' ' + std::to_string(i));
  if (input.file.format == File_format::obj)
    name += " (number " + std::to_string(i + 1) + " in the OBJ file)";
  return name;
}

}  // namespace

Surface_input prepare(Surface_file file)
{
  Surface_input input;
  input.file = std::move(file);
  auto [corners, face_in_file, places, triangulated] = triangulate(input.file);
  input.face_in_file = std::move(face_in_file);
  input.triangulated = triangulated;
  input.vertex_in_file = leave_out_unreferenced(input.file.points.size(), corners);
  input.mesh = CGP::Mesh_view(points_of(input.file, input.vertex_in_file), std::move(corners));
  input.unreferenced = static_cast<int>(input.file.points.size() - input.vertex_in_file.size());
  if (triangulated > 0)
    input.notes.push_back(count_of(static_cast<std::size_t>(triangulated), "polygon") +
                          " triangulated for the computation, written as they were");
  if (input.unreferenced > 0)
    input.notes.push_back(note_of_unreferenced(input.unreferenced, input.vertex_in_file));
  input.coinciding = coinciding_at_boundary(input.mesh);
  repair_orientation(input);
  turn_outward(input);
  return input;
}

namespace {

Bad_faces bad_faces(bool is_repaired)
{
  return is_repaired ? Bad_faces::kept : Bad_faces::refused;
}

Surface_input prepared(Surface_file file, bool is_repaired)
{
  std::optional<Repair> repaired;
  std::vector<std::string> notes;
  if (is_repaired) {
    repaired = repair(file);
    notes = repaired->notes();
  }
  notes.insert(notes.begin(), file.notes.begin(), file.notes.end());
  file.notes.clear();  // those of a writer follow
  Surface_input input = prepare(std::move(file));
  input.repair = std::move(repaired);
  input.notes.insert(input.notes.begin(), notes.begin(), notes.end());
  if (input.coinciding > 0 && !is_repaired)
    input.notes.push_back(count_of(static_cast<std::size_t>(input.coinciding), "vertex") +
                          " at the boundary on others; --repair merges them");
  return input;
}

}  // namespace

Surface_input read_surface_input(const std::string& path, bool is_repaired)
{
  return prepared(read_surface(path == "-" ? "/dev/stdin" : path, bad_faces(is_repaired)),
                  is_repaired);
}

Surface_input parse_surface_input(std::string_view bytes, const std::string& name, bool is_repaired)
{
  return prepared(parse_surface(bytes, name, bad_faces(is_repaired)), is_repaired);
}

Surface_input as_input(const CGP::Mesh_view& mesh)
{
  Surface_file file;
  for (int v = 0; v < mesh.size_of_vertices(); ++v) {
    const Eigen::Vector3d p = mesh.position(v);
    file.points.push_back({p.x(), p.y(), p.z()});
  }
  Polygons& polygons = file.polygons;
  for (const auto& corners : mesh.corners()) {
    polygons.corners.insert(polygons.corners.end(), corners.begin(), corners.end());
    polygons.first.push_back(polygons.corners.size());
  }
  file.vertices.size = file.points.size();
  file.faces.size = polygons.size();
  return prepare(std::move(file));
}

std::string name_of_vertex(const Surface_input& input, int v)
{
  const int i = input.vertex_in_file[static_cast<std::size_t>(v)];
  return with_obj_number(input, "vertex", before_repair(&Repair::vertex_in_file, input, i));
}

std::string name_of_face(const Surface_input& input, int f)
{
  const int i = input.face_in_file[static_cast<std::size_t>(f)];
  return with_obj_number(input, "face", before_repair(&Repair::face_in_file, input, i));
}

std::string name_of_edge(const Surface_input& input, int k)
{
  const auto& ends = input.mesh.ends(k);
  return "the edge from " + name_of_vertex(input, ends[0]) + " to " +
         name_of_vertex(input, ends[1]);
}

std::vector<double> to_file_vertices(const Surface_input& input, const Eigen::VectorXd& values,
                                     double elsewhere)
{
  std::vector<double> result(input.file.points.size(), elsewhere);
  for (std::size_t v = 0; v < input.vertex_in_file.size(); ++v)
    result[static_cast<std::size_t>(input.vertex_in_file[v])] =
        values[static_cast<Eigen::Index>(v)];
  return result;
}

}  // namespace conformal
