// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Command.h"
#include "option_groups.h"

#include "conformal/input/Defects.h"
#include "conformal/input/same_faces.h"
#include "conformal/process/Failure.h"
#include "conformal/process/text.h"
#include "conformal/report/certificate.h"
#include "conformal/report/keep_exhibit.h"
#include "conformal/report/report_input.h"
#include "conformal/transform/write_result.h"

#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/Normalized_frame.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

namespace conformal {
namespace {

const char* const compare_about =
    "Measures the map between two meshes with the same faces: angles, lengths, flips, energies.\n"
    "-o writes the second one with the vertex property quality (quasi-conformal error).\n"
    "Example: conformal compare bear.off bear_spin.ply --json map.json";

struct Compare_options {
  std::string before, after;
};

void add_options(CLI::App& command, Compare_options& compare, Common_options& common)
{
  command.add_option("before", compare.before, "mesh file")->required();
  command.add_option("after", compare.after, "mesh file with the same faces")->required();
  add_mesh_output(command, common, "the second mesh, with quality");
  add_html(command, common);
}

Files files(const Compare_options& compare)
{
  return {{"the mesh before", compare.before},
          {"the mesh after", compare.after, Named_file::Role::replaceable}};
}

// Components and boundaries do not matter to a map.
void require_measurable(const Surface_input& input)
{
  const Defects defects = find_defects(input);
  for (const auto* kind : {&defects.of_topology, &defects.of_geometry})
    if (!kind->empty()) throw unsuitable(input.file.path, kind->front());
}

void tell_histogram(const CGP::Mesh_view& a, const CGP::Points& b, Report& report)
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
    report.show("area with error " + text_of(begin, 3) + " to " + end,
                text_of(100 * share[i], 3) + " %");
  }
}

void tell_energies(const CGP::Mesh_view& a, const CGP::Mesh_view& b, Report& report)
{
  const auto alignment = CGP::align(a.positions(), b.positions());
  const std::string distance = "result/similarity_distance/", energy = "result/willmore_energy/";
  report.tell(distance + "rms", "distance from similar, rms / diagonal", alignment.rms);
  report.tell(distance + "max", "distance from similar, max / diagonal", alignment.max);
  report.tell(energy + "before", "Willmore energy before", CGP::willmore_energy(a));
  report.tell(energy + "after", "Willmore energy after", CGP::willmore_energy(b));
}

void tell(const CGP::Mesh_view& mesh, const CGP::Points& after, Report& report)
{
  const CGP::Mesh_view a = CGP::internal::in_own_frame(mesh);
  const CGP::Mesh_view b = CGP::internal::in_own_frame({after, mesh.corners()});
  CGP::Conformality map =
      CGP::conformality(a, b.positions(), CGP::neighbourhood_normals(a, b.positions()));
  const double unit = CGP::internal::Normalized_frame(after).unit() /
                      CGP::internal::Normalized_frame(mesh.positions()).unit();
  map.scale.min_scale *= unit;
  map.scale.max_scale *= unit;
  tell_conformality(map, mesh.size_of_faces(), report);
  tell_energies(a, b, report);
  tell_histogram(a, b.positions(), report);
}

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
  tell(before.mesh, positions, session.report());
  session.end_stage("measure");
  keep_exhibit(before, positions, session);
  if (output.empty()) return;
  set_quality(before, positions, after.file);
  write_mesh(output, after.file, session);
  session.end_stage("write");
}

}  // namespace

Command compare_command()
{
  return make_command<Compare_options>("compare", compare_about, add_options, files, compare);
}

}  // namespace conformal
