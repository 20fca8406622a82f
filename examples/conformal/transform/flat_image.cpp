// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "flat_image.h"

#include "flat_distortion.h"
#include "solve_spin.h"
#include "unbend.h"

#include "conformal/process/Failure.h"
#include "conformal/process/interruption.h"
#include "conformal/process/text.h"
#include "conformal/report/certificate.h"
#include "conformal/report/solve_flat.h"

#include <Conformal_geometry_processing/mesh/topology.h>

#include <algorithm>
#include <string>
#include <utility>

namespace conformal {
namespace {

/// what to try where a method fails
std::string other_ways(const Flatten_options& options)
{
  if (options.method != Flatten_method::spectral) return "--method spectral";
  if (!options.cut.opens_closed()) return "to cut the surface open, or remove slivers";
  if (options.cut.finds_tips) return "to remove slivers: 4 to 64 tips of cuts were tried";
  const int tips = 2 * std::max(options.cut.tips, static_cast<int>(options.cut.cones.size()));
  return "more cuts: --cut=" + std::to_string(tips) + ", or remove slivers";
}

void tell(const CGP::Parameterization_report& map, Report& report)
{
  report.tell("result/eigenvalue", "eigenvalue", map.eigenvalue);
  report.tell("result/next_eigenvalue", "next eigenvalue", map.next_eigenvalue);
  report.tell("result/residual", "residual of the eigenvector", map.residual, 3);
  report.tell("result/iterations", "iterations", map.iterations);
  report.set("result/boundary_loops", map.boundary_loops);
  report.set("result/normalized_vertices", map.normalized_vertices);
}

void tell(const Flat_distortion& distortion, int faces, Report& report)
{
  report.set("result/collapsed_faces", distortion.collapsed);
  if (distortion.collapsed > 0)
    report.show("faces without area in the plane, not measured",
                std::to_string(distortion.collapsed) + " of " + std::to_string(faces));
  tell_conformality(distortion.map, faces - distortion.collapsed, report);
  report.set("result/overlap/faces", distortion.overlap.faces);
  report.tell("result/overlap/share", "share of the image that overlaps", distortion.overlap.share,
              3);
  report.show("standard deviation of the log of the scale",
              text_of(distortion.map.scale.log_deviation, 3));
  const auto& Q = distortion.uniform_quasi_conformal;
  report.tell("result/uniform_quasi_conformal/mean", "quasi-conformal error, mean of faces",
              Q.mean);
  report.set("result/uniform_quasi_conformal/p99", Q.p99);
}

void add_seconds(const CGP::Parameterization_report& map, Stage_seconds& seconds)
{
  seconds.add("setup", map.seconds.setup);
  seconds.add("assembly", map.seconds.assembly);
  seconds.add("factorization", map.seconds.factorization);
  seconds.add("eigenvector", map.seconds.eigenvector);
  seconds.add("certificate", map.seconds.certificate);
}

std::string fault_of(const Flat_distortion& distortion, int faces, const std::string& easier)
{
  if (distortion.collapsed == 0) return {};
  return count_of(static_cast<std::size_t>(distortion.collapsed), "face") + " of " +
         std::to_string(faces) +
         " shrink to nothing in the plane, below the resolution of the numbers; try: " + easier;
}

std::string fault_of(const CGP::Parameterization_report& map, const std::string& easier)
{
  if (map) return {};
  return "the eigenvector did not converge: residual " + text_of(map.residual, 3) + " after " +
         count_of(static_cast<std::size_t>(map.iterations), "iteration") + "; try: " + easier;
}

/// a map to the plane, and what it is judged by
struct Flat_image {
  CGP::Points positions;
  Verdict verdict;
};

/// \param fault found by the method, empty if none
Flat_image judged(const Surface_input& input, CGP::Points positions, const std::string& fault,
                  const Flatten_options& options, Session& session)
{
  const int faces = input.mesh.size_of_faces();
  const Flat_distortion distortion = flat_distortion(input.mesh, positions);
  tell(distortion, faces, session.report());
  Evidence evidence{positions};
  evidence.map = distortion.map;
  evidence.fault = fault.empty() ? fault_of(distortion, faces, other_ways(options)) : fault;
  const Verdict verdict = judge(evidence, options.limits, other_ways(options));
  return {std::move(positions), verdict};
}

Flat_image spectral_image(const Surface_input& input, const Seams& seams,
                          const Flatten_options& options, Session& session)
{
  CGP::Parameterization_options how;
  how.seams = seams;
  if (options.method == Flatten_method::dirac)
    how.normals = CGP::Parameterization_options::Normals::of_vertices;
  if (options.all_loops) how.boundary = CGP::Parameterization_options::Boundary::all_loops;
  how.tolerance = options.tolerance;
  const auto [z, report] = solve_flat(input.mesh, how, "flatten");
  tell(report, session.report());
  add_seconds(report, session.outcome().seconds);
  return judged(input, CGP::in_space(z), fault_of(report, other_ways(options)), options, session);
}

std::string fault_of(const Unbent_surface& unbent, const std::string& easier)
{
  if (unbent.is_flat()) return {};
  const std::string state =
      unbent.steps == 0
          ? "it does not unbend"
          : "after " + count_of(static_cast<std::size_t>(unbent.steps), "step") +
                " its height is still " + text_of(100 * unbent.height, 3) + " % of its diameter";
  return state +
         ": farther on edges would not close up, or faces flip, as the mesh is too coarse for how "
         "much it bends or scales; try: " +
         easier;
}

/// The projection to the plane is written, so it is what is judged.
Flat_image projected(const Surface_input& input, Unbent_surface&& unbent,
                     const Flatten_options& options, Session& session)
{
  CGP::Spin_result& nearly_flat = unbent.result;
  session.report().tell("result/height", "height by diameter", unbent.height, 3);
  nearly_flat.positions.row(2).setZero();
  const int faces = input.mesh.size_of_faces();
  const Flat_distortion distortion = flat_distortion(input.mesh, nearly_flat.positions);
  nearly_flat.report.conformality = distortion.map;
  session.report().set("result/collapsed_faces", distortion.collapsed);
  tell_certificate(nearly_flat.report, faces - distortion.collapsed, session.outcome());
  Evidence evidence{nearly_flat.positions, nearly_flat.report};
  const char* const easier = "conformal flatten without --planar, or a finer mesh";
  evidence.fault = fault_of(unbent, easier);
  if (evidence.fault.empty()) evidence.fault = fault_of(distortion, faces, easier);
  const Verdict verdict = judge(evidence, options.limits, easier);
  return {std::move(nearly_flat.positions), verdict};
}

Flat_image planar_image(const Surface_input& input, const Flatten_options& options,
                        Session& session)
{
  if (!CGP::topology(input.mesh).is_disk())
    throw unsuitable(input.file.path,
                     "the surface is not a disk (one loop, no handles), wanted for --planar; try: "
                     "without --planar");
  return projected(input, unbend(input.mesh, options.limits.closure / 2), options, session);
}

}  // namespace

CGP::Points flat_image(const Surface_input& input, const Seams& seams,
                       const Flatten_options& options, Session& session)
{
  const char* const methods[] = {"spectral", "dirac", "cones"};
  session.report().set("result/method",
                       options.planar ? "planar" : methods[static_cast<int>(options.method)]);
  const Flat_image image = options.planar ? planar_image(input, options, session)
                                          : spectral_image(input, seams, options, session);
  throw_if_interrupted();
  session.end_stage("solve");
  session.conclude(image.verdict, on_fault(options.force));
  return image.positions;
}

}  // namespace conformal
