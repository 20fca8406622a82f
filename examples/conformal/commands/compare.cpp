// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "compare.h"

#include "conformal/input/Defects.h"
#include "conformal/input/same_faces.h"
#include "conformal/io/write_surface.h"
#include "conformal/process/Failure.h"
#include "conformal/report/keep_exhibit.h"
#include "conformal/report/report_input.h"
#include "conformal/report/verification.h"
#include "conformal/transform/write_result.h"

#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/measure/quasi_conformal_error.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#include <algorithm>

namespace conformal {
namespace {

// Components and boundaries do not matter to a map.
void require_measurable(const Surface_input& input)
{
  const Defects defects = find_defects(input);
  for (const auto* kind : {&defects.of_topology, &defects.of_geometry})
    if (!kind->empty()) throw unsuitable(input.file.path, kind->front());
}

// Each in its own unit frame, in which nothing overflows.
CGP::Mesh_view in_frame(const CGP::Mesh_view& mesh, const CGP::Points& positions)
{
  CGP::Mesh_view result = mesh;
  result.set_positions(CGP::internal::Normalized_frame(positions).to_frame(positions));
  return result;
}

void tell_histogram(const CGP::Mesh_view& a, const CGP::Points& b, Report& report, Table& table)
{
  const int bins = 10;
  const double low = 1, high = 2;
  const Eigen::VectorXd share =
      CGP::histogram(CGP::quasi_conformal_errors(a, b), CGP::face_areas(a), bins, low, high);
  report.set("result/quasi_conformal/histogram/low", low);
  report.set("result/quasi_conformal/histogram/high", high);
  report.set("result/quasi_conformal/histogram/share",
             Report::Value(std::vector<double>(share.begin(), share.end())));
  for (int i = 0; i < bins; ++i) {
    const double begin = low + (high - low) * i / bins;
    const std::string end = i + 1 < bins ? text_of(begin + (high - low) / bins, 3) : "...";
    table.add("area with error " + text_of(begin, 3) + " to " + end,
              text_of(100 * share[i], 3) + " %");
  }
}

void tell_energies(const CGP::Mesh_view& a, const CGP::Mesh_view& b, Report& report, Table& table)
{
  const auto alignment = CGP::align(a.positions(), b.positions());
  const auto tell = [&](const std::string& place, const std::string& label, double value) {
    report.set("result/" + place, value);
    table.add(label, value);
  };
  tell("similarity_distance/rms", "distance from similar, rms / diagonal", alignment.rms);
  tell("similarity_distance/max", "distance from similar, max / diagonal", alignment.max);
  tell("willmore_energy/before", "Willmore energy before", CGP::willmore_energy(a));
  tell("willmore_energy/after", "Willmore energy after", CGP::willmore_energy(b));
}

void tell(const CGP::Mesh_view& mesh, const CGP::Points& after, Session& session)
{
  Table table;
  const CGP::Mesh_view a = in_frame(mesh, mesh.positions()), b = in_frame(mesh, after);
  CGP::Conformality map =
      CGP::conformality(a, b.positions(), CGP::neighbourhood_normals(a, b.positions()));
  const double unit = CGP::internal::Normalized_frame(after).unit() /
                      CGP::internal::Normalized_frame(mesh.positions()).unit();
  map.scale.min_scale *= unit;
  map.scale.max_scale *= unit;
  report_conformality(map, session.report());
  add_conformality(map, mesh.size_of_faces(), table);
  tell_energies(a, b, session.report(), table);
  tell_histogram(a, b.positions(), session.report(), table);
  session.print(table.text());
}

}  // namespace

void compare(const Compare_options& options, Session& session)
{
  const std::string& output = session.options().output;
  if (!output.empty()) require_writable(output);
  const Surface_input before = read_surface_input(options.before);
  Surface_input after = read_surface_input(options.after);
  session.end_stage("read");
  session.note_all(before.notes);
  report_input(before, session.report());
  if (session.options().strict) require_untouched(before);
  require_same_faces(before.file, after.file);
  require_measurable(before);
  const CGP::Points positions = positions_in(before, after.file);
  tell(before.mesh, positions, session);
  session.end_stage("measure");
  keep_exhibit(before, positions, session);
  if (output.empty()) return;
  set_quality(before, positions, after.file);
  session.note_all(write_surface(output, after.file));
  session.end_stage("write");
}

}  // namespace conformal
