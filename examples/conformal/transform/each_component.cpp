// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "each_component.h"

#include "Component_failures.h"

#include "conformal/process/text.h"
#include "conformal/report/Grid.h"

#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/Mesh_component.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <utility>

namespace conformal {
namespace {

std::vector<int> selected(const std::vector<int>& values, const std::vector<int>& indices)
{
  std::vector<int> result;
  for (const int i : indices) result.push_back(values[static_cast<std::size_t>(i)]);
  return result;
}

/// of these elements the numbers in the file of the user, before it was repaired
std::vector<int> numbers_in_file(const Surface_input& input, const std::vector<int>& in_file,
                                 std::vector<int> Repair::*before, const std::vector<int>& elements)
{
  const std::vector<int> now = selected(in_file, elements);
  return input.repair ? selected((*input.repair).*before, now) : now;
}

std::vector<Component> components_of(const Surface_input& input)
{
  std::vector<Component> components;
  for (CGP::internal::Mesh_component& part : CGP::mesh_components(input.mesh)) {
    Component c;
    c.name = "component " + std::to_string(components.size()) + " (from " +
             name_of_vertex(input, part.vertices.front()) + ")";
    c.input.file.path = input.file.path;
    c.input.file.format = input.file.format;
    c.input.mesh = std::move(part.mesh);
    c.input.vertex_in_file =
        numbers_in_file(input, input.vertex_in_file, &Repair::vertex_in_file, part.vertices);
    c.input.face_in_file =
        numbers_in_file(input, input.face_in_file, &Repair::face_in_file, part.faces);
    c.vertices = std::move(part.vertices);
    c.faces = std::move(part.faces);
    components.push_back(std::move(c));
  }
  return components;
}

/// Reports the counts of a component, independently of its result
void report_counts(const Component& component, Report& report)
{
  const auto t = CGP::topology(component.input.mesh);
  report.set("first_vertex", component.input.vertex_in_file.front());
  report.set("vertices", t.vertices);
  report.set("faces", t.faces);
  report.set("boundary_loops", t.boundary_loops);
  report.set("genus", t.genus);
}

/// its place in the report of the whole; seconds are added up there
void report_component(const Report& own, std::size_t number, Report& whole)
{
  const std::string seconds = "seconds/";
  for (const auto& [place, value] : own.entries()) {
    if (place.compare(0, seconds.size(), seconds) == 0)
      whole.add_seconds(place.substr(seconds.size()), std::get<double>(value));
    else if (place != "command" && place != "version")
      whole.set("components/" + std::to_string(number) + "/" + place, value);
  }
}

/// the text of an entry of a report, or nothing
std::string text_at(const Report& report, const std::string& place)
{
  for (const auto& [known, value] : report.entries()) {
    if (known != place) continue;
    if (const auto* number = std::get_if<double>(&value)) return text_of(*number, 5);
    if (const auto* number = std::get_if<std::int64_t>(&value)) return std::to_string(*number);
    if (const auto* is_so = std::get_if<bool>(&value)) return *is_so ? "yes" : "no";
  }
  return "-";
}

const std::vector<std::pair<std::string, std::string>> columns = {
    {"from vertex", "first_vertex"},
    {"vertices", "vertices"},
    {"faces", "faces"},
    {"loops", "boundary_loops"},
    {"genus", "genus"},
    {"mean Q", "result/quasi_conformal/mean"},
    {"flipped", "result/flipped_faces"},
    {"closure", "result/closure_residual"},
    {"verified", "verified"}};

Grid empty_grid()
{
  std::vector<std::string> headings = {"component"};
  for (const auto& column : columns) headings.push_back(column.first);
  return Grid(std::move(headings));
}

void add_line(const Report& own, std::size_t number, Grid& grid)
{
  std::vector<std::string> cells = {std::to_string(number)};
  for (const auto& column : columns) cells.push_back(text_at(own, column.second));
  grid.add(std::move(cells));
}

bool is_verified(const Report& own)
{
  return text_at(own, "verified") == "yes";
}

/// whether it is closed and has a negative volume; it may be no manifold
bool is_inside_out(CGP::Mesh_view mesh)
{
  for (int k = 0; k < mesh.size_of_edges(); ++k)
    if (mesh.halfedges_end(k) - mesh.halfedges_begin(k) != 2) return false;
  mesh.set_positions(CGP::internal::Normalized_frame(mesh.positions()).to_frame(mesh.positions()));
  return CGP::signed_volume(mesh) < 0;
}

}  // namespace

CGP::Points each_component(const Surface_input& input, Session& session, const Component_work& work)
{
  Common_options silent = session.options();
  silent.quiet = true;
  const std::vector<Component> components = components_of(input);
  Component_failures failures(input.file.path, components.size());
  CGP::Points positions = input.mesh.positions();
  Grid grid = empty_grid();
  int verified = 0;
  for (std::size_t c = 0; c < components.size(); ++c) {
    Session own(silent, "");
    report_counts(components[c], own.report());
    const std::string reason = failures.attempt(components[c].name, [&] {
      positions(Eigen::indexing::all, components[c].vertices) = work(components[c], own);
    });
    if (!reason.empty()) own.report().set("verified", false);
    if (!reason.empty()) own.report().set("error", reason.c_str());
    for (const std::string& note : own.notes()) session.note(components[c].name + ": " + note);
    verified += is_verified(own.report());
    report_component(own.report(), c, session.report());
    add_line(own.report(), c, grid);
  }
  const int count = static_cast<int>(components.size());
  session.report().set("result/components", count);
  session.report().set("result/verified_components", verified);
  session.report().set("verified", verified == count);
  session.print(grid.text());
  failures.throw_if_any();
  session.begin_stage();
  return positions;
}

void turn_components_outward(Surface_input& input)
{
  auto corners = input.mesh.corners();
  std::size_t count = 0;
  for (const CGP::internal::Mesh_component& part : CGP::mesh_components(input.mesh)) {
    if (!is_inside_out(part.mesh)) continue;
    ++count;
    for (const int f : part.faces)
      std::swap(corners[static_cast<std::size_t>(f)][1], corners[static_cast<std::size_t>(f)][2]);
  }
  if (count == 0) return;
  input.mesh = CGP::Mesh_view(input.mesh.positions(), std::move(corners));
  input.notes.push_back(count_of(count, "component") +
                        " inside out: computed with outward normals, faces are written as they "
                        "were");
}

}  // namespace conformal
