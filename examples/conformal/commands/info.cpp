// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "info.h"

#include "conformal/input/Closed_curve.h"
#include "conformal/input/Defects.h"
#include "conformal/process/Failure.h"
#include "conformal/report/Shape.h"
#include "conformal/report/Table.h"
#include "conformal/report/report_input.h"

#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/boundary_loops.h>
#include <Conformal_geometry_processing/mesh/topology.h>

#include <cmath>

namespace conformal {
namespace {

void tell_counts(const Surface_input& input, const Defects& defects, Table& table)
{
  const CGP::Mesh_view& mesh = input.mesh;
  table.add("vertices", static_cast<int>(input.file.points.size()));
  table.add("edges", mesh.size_of_edges());
  table.add("faces", static_cast<int>(input.file.polygons.size()));
  if (input.triangulated > 0) table.add("triangles", mesh.size_of_faces());
  table.add("unreferenced vertices", input.unreferenced);
  int components = 0;
  for (const int c : CGP::connected_components(mesh)) components = std::max(components, c + 1);
  table.add("components", components);
  if (!defects.of_topology.empty()) return;
  const auto t = CGP::topology(mesh);
  table.add("boundary loops", t.boundary_loops);
  table.add("genus", t.genus);
}

void tell_boundary(const Surface_input& input, Report& report, Table& table)
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
      table.add("boundary loop " + std::to_string(l),
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

// Tells numbers of a surface, measured in a frame of unit size in which nothing overflows.
class Teller {
 public:
  Teller(const Surface_input& input, Report& report, Table& table)
      : m_frame(input.mesh.positions()), m_mesh(input.mesh), m_report(report), m_table(table)
  {
    m_mesh.set_positions(m_frame.to_frame(m_mesh.positions()));
  }

  void tell_shape()
  {
    const Shape s = shape(m_mesh);
    tell("area", "area", s.area * std::pow(m_frame.unit(), 2));
    tell("diagonal", "bounding-box diagonal", s.diagonal * m_frame.unit());
    tell("min_angle", "smallest angle (degrees)", s.min_angle);
    tell("edge_ratio", "longest / shortest edge", s.edge_ratio);
    tell("negative_cotan_weights", "share of negative cotan weights", s.negative_weights);
  }

  /// \pre there are no defects of topology or geometry
  void tell_energies(bool is_turned_outward)
  {
    const double sign = is_turned_outward ? -1 : 1;
    if (CGP::topology(m_mesh).is_closed())
      tell("volume", "volume", sign * CGP::signed_volume(m_mesh) * std::pow(m_frame.unit(), 3));
    tell("willmore_energy", "Willmore energy (sphere: 12.566)", CGP::willmore_energy(m_mesh));
    tell("steiner_willmore_energy", "the same after Steiner", CGP::steiner_willmore_energy(m_mesh));
  }

 private:
  void tell(const std::string& place, const std::string& label, double value)
  {
    m_report.set("result/" + place, value);
    m_table.add(label, value);
  }

  CGP::internal::Normalized_frame m_frame;
  CGP::Mesh_view m_mesh;
  Report& m_report;
  Table& m_table;
};

std::vector<std::string> problems_of(const Defects& defects)
{
  std::vector<std::string> problems;
  for (const auto* kind : {&defects.of_topology, &defects.of_components, &defects.of_geometry})
    problems.insert(problems.end(), kind->begin(), kind->end());
  return problems;
}

}  // namespace

void info(const Info_options& options, Session& session)
{
  const Surface_input input = read_surface_input(options.input, session.options().repair);
  session.end_stage("read");
  session.note_all(input.notes);
  report_input(input, session.report());
  const Defects defects = find_defects(input);
  Table table;
  tell_counts(input, defects, table);
  table.add("orientation", orientation_of(input));
  session.report().set("result/orientation", Report::Value(orientation_of(input)));
  Teller teller(input, session.report(), table);
  teller.tell_shape();
  if (defects.of_topology.empty() && defects.of_geometry.empty())
    teller.tell_energies(input.is_turned_outward);
  if (defects.of_topology.empty()) tell_boundary(input, session.report(), table);
  const std::vector<std::string> problems = problems_of(defects);
  for (const std::string& problem : problems) table.add("problem", problem);
  session.report().set("result/unreferenced_vertices", input.unreferenced);
  session.report().set("result/problems", problems);
  session.end_stage("measure");
  session.print(table.text());
  if (session.options().strict) {
    require_untouched(input);
    if (!problems.empty()) throw unsuitable(options.input, problems.front());
  }
}

}  // namespace conformal
