// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "report_input.h"

#include "conformal/input/Defects.h"

#include <Conformal_geometry_processing/mesh/topology.h>

namespace conformal {
namespace {

void report_repair(const Repair& repair, Report& report, const std::string& place)
{
  report.set(place + "/merged_points", repair.merged_points);
  report.set(place + "/removed_faces", repair.removed_faces);
  report.set(place + "/shortened_faces", repair.shortened_faces);
  report.set(place + "/bridged_faces", repair.bridged_faces);
  report.set(place + "/turned_faces", repair.turned_faces);
  report.set(place + "/cut_edges", repair.cut_edges);
  report.set(place + "/added_vertices", repair.added_vertices);
  report.set(place + "/removed_vertices", repair.removed_vertices);
  report.set(place + "/flipped_edges", repair.flipped_edges);
  report.set(place + "/collapsed_edges", repair.collapsed_edges);
  report.set(place + "/longest_collapsed_edge", repair.longest_collapsed_edge);
  report.set(place + "/removed_flat_faces", repair.removed_flat_faces);
  report.set(place + "/cut_polygons", repair.cut_polygons);
  if (!repair.has_changed_anything()) return;
  report.set(place + "/new_vertex", repair.new_vertex);
  report.set(place + "/new_face", repair.new_face);
  report.set(place + "/vertex_in_file", repair.vertex_in_file);
  report.set(place + "/face_in_file", repair.face_in_file);
}

}  // namespace

void report_input(const Surface_input& input, Report& report, const std::string& place)
{
  report.set(place + "/file", input.file.path);
  report.set(place + "/vertices", static_cast<int>(input.file.points.size()));
  report.set(place + "/faces", static_cast<int>(input.file.polygons.size()));
  if (input.repair) report_repair(*input.repair, report, place + "/repair");
  const bool is_manifold = find_defects(input).of_topology.empty();
  const auto t = is_manifold ? CGP::topology(input.mesh) : CGP::internal::Topology();
  using Value = Report::Value;
  report.set(place + "/boundary_loops",
             is_manifold ? Value(std::int64_t{t.boundary_loops}) : Value(nullptr));
  report.set(place + "/genus", is_manifold ? Value(std::int64_t{t.genus}) : Value(nullptr));
}

}  // namespace conformal
