// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Command.h"
#include "option_groups.h"

#include "conformal/input/Closed_curve.h"
#include "conformal/input/Defects.h"
#include "conformal/process/Failure.h"
#include "conformal/process/text.h"
#include "conformal/report/Shape.h"
#include "conformal/report/report_input.h"

#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <cmath>

namespace conformal {
namespace {

const char* const info_about =
    "Tells what a mesh is: counts, topology, orientation, shape of its triangles, energies, and\n"
    "all that keeps it from being transformed.\n"
    "Example: conformal info bear.off --json bear.json";

struct Info_options {
  std::string input;
};

void add_options(CLI::App& command, Info_options& info, Common_options& common)
{
  add_repair(command, common);
  add_input(command, info.input);
}

Files files(const Info_options& info)
{
  return {{"the input", info.input, Named_file::Role::replaceable}};
}

void tell_counts(const Surface_input& input, const Defects& defects, Report& report)
{
  const CGP::Mesh_view& mesh = input.mesh;
  report.show("vertices", std::to_string(static_cast<int>(input.file.points.size())));
  report.show("edges", std::to_string(mesh.size_of_edges()));
  report.show("faces", std::to_string(static_cast<int>(input.file.polygons.size())));
  if (input.triangulated > 0) report.show("triangles", std::to_string(mesh.size_of_faces()));
  report.show("unreferenced vertices", std::to_string(input.unreferenced));
  report.show("boundary vertices on others", std::to_string(input.coinciding));
  int components = 0;
  for (const int c : CGP::connected_components(mesh)) components = std::max(components, c + 1);
  report.show("components", std::to_string(components));
  if (!defects.of_topology.empty()) return;
  const auto t = CGP::topology(mesh);
  report.show("boundary loops", std::to_string(t.boundary_loops));
  report.show("genus", std::to_string(t.genus));
}

void tell_boundary_loops(const Surface_input& input, Report& report)
{
  const std::size_t shown = 10;
  const std::vector<std::vector<int>> loops = CGP::boundary_loops(input.mesh);
  std::vector<double> first, sizes, lengths;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const int start = input.vertex_in_file[static_cast<std::size_t>(loops[l].front())];
    first.push_back(start);
    sizes.push_back(static_cast<double>(loops[l].size()));
    lengths.push_back(Closed_curve(input.mesh, loops[l]).length());
    if (l < shown)
      report.show("boundary loop " + std::to_string(l),
                  count_of(loops[l].size(), "vertex") + ", length " + text_of(lengths.back()) +
                      ", from " + name_of_vertex(input, loops[l].front()));
  }
  report.set("result/boundary/first_vertex", Report::Value(first));
  report.set("result/boundary/vertices", Report::Value(sizes));
  report.set("result/boundary/length", Report::Value(lengths));
}

std::string orientation_of(const Surface_input& input)
{
  if (!input.is_orientable) return "not orientable";
  if (input.turned_faces > 0)
    return count_of(static_cast<std::size_t>(input.turned_faces), "face") + " against the others";
  return input.is_turned_outward ? "consistent, inward" : "consistent";
}

/// Tells numbers of a surface, measured in a frame of unit size in which nothing overflows.
void tell_shape(const CGP::Mesh_view& mesh, double unit, Report& report)
{
  const Shape s = shape(mesh);
  report.tell("result/area", "area", s.area * std::pow(unit, 2));
  report.tell("result/diagonal", "bounding-box diagonal", s.diagonal * unit);
  report.tell("result/min_angle", "smallest angle (degrees)", s.min_angle);
  report.tell("result/edge_ratio", "longest / shortest edge", s.edge_ratio);
  report.tell("result/negative_cotan_weights", "share of negative cotan weights",
              s.negative_weights);
}

/// \pre there are no defects of topology or geometry
void tell_energies(const CGP::Mesh_view& mesh, double unit, double sign, Report& report)
{
  if (CGP::topology(mesh).is_closed())
    report.tell("result/volume", "volume", sign * CGP::signed_volume(mesh) * std::pow(unit, 3));
  report.tell("result/willmore_energy", "Willmore energy (sphere: 12.566)",
              CGP::willmore_energy(mesh));
  report.tell("result/steiner_willmore_energy", "the same after Steiner",
              CGP::steiner_willmore_energy(mesh));
}

void tell_surface(const Surface_input& input, const Defects& defects, Report& report)
{
  const CGP::internal::Normalized_frame frame(input.mesh.positions());
  CGP::Mesh_view mesh = input.mesh;
  mesh.set_positions(frame.to_frame(mesh.positions()));
  tell_shape(mesh, frame.unit(), report);
  if (defects.of_topology.empty() && defects.of_geometry.empty())
    tell_energies(mesh, frame.unit(), input.is_turned_outward ? -1 : 1, report);
  if (defects.of_topology.empty()) tell_boundary_loops(input, report);
}

std::vector<std::string> problems_of(const Defects& defects)
{
  std::vector<std::string> problems;
  for (const auto* kind : {&defects.of_topology, &defects.of_components, &defects.of_geometry})
    problems.insert(problems.end(), kind->begin(), kind->end());
  return problems;
}

void info(const Info_options& options, Session& session)
{
  const Surface_input input = read_surface_input(options.input, session.options().repair);
  session.end_stage("read");
  session.note_all(input.notes);
  Report& report = session.report();
  report_input(input, report);
  const Defects defects = find_defects(input);
  tell_counts(input, defects, report);
  report.show("orientation", orientation_of(input));
  report.set("result/orientation", Report::Value(orientation_of(input)));
  tell_surface(input, defects, report);
  const std::vector<std::string> problems = problems_of(defects);
  for (const std::string& problem : problems) report.show("problem", problem);
  report.set("result/unreferenced_vertices", input.unreferenced);
  report.set("result/coinciding_vertices", input.coinciding);
  report.set("result/problems", problems);
  session.end_stage("measure");
  if (!session.options().strict) return;
  require_untouched(input);
  if (!problems.empty()) throw unsuitable(options.input, problems.front());
}

}  // namespace

Command info_command()
{
  return make_command<Info_options>("info", info_about, add_options, files, info);
}

}  // namespace conformal
