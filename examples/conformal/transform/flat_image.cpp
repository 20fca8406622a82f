// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "flat_image.h"

#include "conformal/process/Failure.h"
#include "conformal/report/Table.h"
#include "conformal/report/solve_flat.h"
#include "conformal/report/verification.h"

#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/parameterization/planar_directions.h>
#include <Conformal_geometry_processing/surfaces/minimal_surface.h>

namespace conformal {
namespace {

const char* const other_ways = "to cut the surface open, or remove slivers";

void tell(const CGP::Parameterization_report& map, int faces, Session& session)
{
  Report& report = session.report();
  report.set("result/eigenvalue", map.eigenvalue);
  report.set("result/next_eigenvalue", map.next_eigenvalue);
  report.set("result/residual", map.residual);
  report.set("result/iterations", map.iterations);
  report.set("result/boundary_loops", map.boundary_loops);
  report.set("result/normalized_vertices", map.normalized_vertices);
  report_conformality(map.conformality, report);
  report.set("result/uniform_quasi_conformal/mean", map.uniform_quasi_conformal.mean);
  report.set("result/uniform_quasi_conformal/p99", map.uniform_quasi_conformal.p99);
  report.add_seconds("setup", map.seconds.setup);
  report.add_seconds("assembly", map.seconds.assembly);
  report.add_seconds("factorization", map.seconds.factorization);
  report.add_seconds("eigenvector", map.seconds.eigenvector);
  report.add_seconds("certificate", map.seconds.certificate);
  Table table;
  table.add("eigenvalue", map.eigenvalue);
  table.add("next eigenvalue", map.next_eigenvalue);
  table.add("residual of the eigenvector", text_of(map.residual, 3));
  table.add("iterations", map.iterations);
  add_conformality(map.conformality, faces, table);
  table.add("quasi-conformal error, mean of faces", map.uniform_quasi_conformal.mean);
  session.print(table.text());
}

std::string fault_of(const CGP::Parameterization_report& map, int faces,
                     const Verification_limits& limits)
{
  if (!map)
    return "the eigenvector did not converge: residual " + text_of(map.residual, 3) + " after " +
           count_of(static_cast<std::size_t>(map.iterations), "iteration") + "; try: " + other_ways;
  return objection(map.conformality, faces, limits, other_ways);
}

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
  tell(report, faces, session);
  return {CGP::in_space(z), fault_of(report, faces, options.limits)};
}

Flat_image minimal_image(const Surface_input& input, const Flatten_options& options,
                         Session& session)
{
  if (!CGP::topology(input.mesh).is_disk())
    throw unsuitable(options.input,
                     "the surface is not a disk (one loop, no handles), wanted for --planar; try: "
                     "without --planar");
  CGP::Dirac_options how;
  how.tolerance = session.options().tolerance;
  how.random_seed = session.options().seed;
  const CGP::Spin_result result = CGP::spin_to_minimal_surface(
      input.mesh, CGP::Boundary_condition::tangents(CGP::planar_directions(input.mesh)), how,
      "flatten");
  const int faces = input.mesh.size_of_faces();
  report_certificate(result.report, session.report());
  Table table = certificate_table(result.report, faces);
  const Eigen::Vector3d extent =
      result.positions.rowwise().maxCoeff() - result.positions.rowwise().minCoeff();
  const double height = extent.z() / extent.head<2>().norm();
  session.report().set("result/height", height);
  table.add("height by diameter", text_of(height, 3));
  session.print(table.text());
  return {result.positions, objection(result.report, result.positions, faces, options.limits,
                                      "conformal flatten without --planar")};
}

}  // namespace

Flat_image flat_image(const Surface_input& input, const Flatten_options& options, Session& session)
{
  const char* const methods[] = {"spectral", "dirac"};
  session.report().set("result/method",
                       options.planar ? "planar" : methods[static_cast<int>(options.method)]);
  return options.planar ? minimal_image(input, options, session)
                        : spectral_image(input, options, session);
}

}  // namespace conformal
