// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "flat_image.h"

#include "conformal/process/Failure.h"
#include "conformal/process/interruption.h"
#include "conformal/process/text.h"
#include "conformal/report/certificate.h"
#include "conformal/report/solve_flat.h"

#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/parameterization/planar_directions.h>
#include <Conformal_geometry_processing/surfaces/minimal_surface.h>

#include <string>

namespace conformal {
namespace {

const char* const other_ways = "to cut the surface open, or remove slivers";

void tell(const CGP::Parameterization_report& map, int faces, Report& report)
{
  report.tell("result/eigenvalue", "eigenvalue", map.eigenvalue);
  report.tell("result/next_eigenvalue", "next eigenvalue", map.next_eigenvalue);
  report.tell("result/residual", "residual of the eigenvector", map.residual, 3);
  report.tell("result/iterations", "iterations", map.iterations);
  report.set("result/boundary_loops", map.boundary_loops);
  report.set("result/normalized_vertices", map.normalized_vertices);
  tell_conformality(map.conformality, faces, report);
  report.tell("result/uniform_quasi_conformal/mean", "quasi-conformal error, mean of faces",
              map.uniform_quasi_conformal.mean);
  report.set("result/uniform_quasi_conformal/p99", map.uniform_quasi_conformal.p99);
}

void add_seconds(const CGP::Parameterization_report& map, Stage_seconds& seconds)
{
  seconds.add("setup", map.seconds.setup);
  seconds.add("assembly", map.seconds.assembly);
  seconds.add("factorization", map.seconds.factorization);
  seconds.add("eigenvector", map.seconds.eigenvector);
  seconds.add("certificate", map.seconds.certificate);
}

std::string fault_of(const CGP::Parameterization_report& map)
{
  if (map) return {};
  return "the eigenvector did not converge: residual " + text_of(map.residual, 3) + " after " +
         count_of(static_cast<std::size_t>(map.iterations), "iteration") + "; try: " + other_ways;
}

/// a map to the plane, and what it is judged by
struct Flat_image {
  CGP::Points positions;
  Verdict verdict;
};

Flat_image spectral_image(const Surface_input& input, const Flatten_options& options,
                          Session& session)
{
  CGP::Parameterization_options how;
  if (options.method == Flatten_method::dirac)
    how.normals = CGP::Parameterization_options::Normals::of_vertices;
  if (options.all_loops) how.boundary = CGP::Parameterization_options::Boundary::all_loops;
  how.tolerance = options.tolerance;
  const auto [z, report] = solve_flat(input.mesh, how, "flatten");
  const int faces = input.mesh.size_of_faces();
  tell(report, faces, session.report());
  add_seconds(report, session.outcome().seconds);
  const CGP::Points positions = CGP::in_space(z);
  Evidence evidence{positions};
  evidence.map = report.conformality;
  evidence.fault = fault_of(report);
  return {positions, judge(evidence, options.limits, other_ways)};
}

void tell_height(const CGP::Points& positions, Report& report)
{
  const Eigen::Vector3d extent = positions.rowwise().maxCoeff() - positions.rowwise().minCoeff();
  report.tell("result/height", "height by diameter", extent.z() / extent.head<2>().norm(), 3);
}

Flat_image minimal_image(const Surface_input& input, const Flatten_options& options,
                         Session& session)
{
  if (!CGP::topology(input.mesh).is_disk())
    throw unsuitable(input.file.path,
                     "the surface is not a disk (one loop, no handles), wanted for --planar; try: "
                     "without --planar");
  CGP::Dirac_options how;
  how.tolerance = session.options().tolerance;
  how.random_seed = session.options().seed;
  const CGP::Spin_result result = CGP::spin_to_minimal_surface(
      input.mesh, {CGP::Boundary_condition::tangents(CGP::planar_directions(input.mesh))}, how,
      "flatten");
  const int faces = input.mesh.size_of_faces();
  tell_certificate(result.report, faces, session.outcome());
  tell_height(result.positions, session.report());
  return {result.positions, judge({result.positions, result.report}, options.limits,
                                  "conformal flatten without --planar")};
}

}  // namespace

CGP::Points flat_image(const Surface_input& input, const Flatten_options& options, Session& session)
{
  const char* const methods[] = {"spectral", "dirac"};
  session.report().set("result/method",
                       options.planar ? "planar" : methods[static_cast<int>(options.method)]);
  const Flat_image image = options.planar ? minimal_image(input, options, session)
                                          : spectral_image(input, options, session);
  throw_if_interrupted();
  session.end_stage("solve");
  session.conclude(image.verdict, on_fault(options.force));
  return image.positions;
}

}  // namespace conformal
