// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "certificate.h"

#include "verification.h"

#include "conformal/process/text.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace conformal {
namespace {

/// what only a report has room for
void report_details(const CGP::Spin_report& spin, Report& report)
{
  report.set("result/iterations", spin.iterations);
  report.set("result/overlap", spin.overlap);
  report.set("result/substeps", spin.substeps);
  report.set("result/spectral_shift", spin.spectral_shift);
  report.set("result/relaxed", spin.is_relaxed);
  report.set("result/unfinished", spin.is_unfinished);
  report.set("result/dirac_residual", spin.dirac_residual);
  if (spin.branch_gap > 0) report.set("result/branch_gap", spin.branch_gap);
  report.set("result/factorizations", spin.factorizations);
  report.set("result/solves", spin.solves);
  report.set("result/realised_share", spin.realised_share);
  report.set("result/generalized", spin.is_generalized);
  report.set("result/steps", spin.steps);
  report.set("result/reached", spin.reached);
  report.set("result/missing_share", spin.missing_share);
  report.set("result/added_share", spin.added_share);
  report.set("result/period_defect", spin.period_defect);
  report.set("steps", Report::Value(std::vector<double>()));
}

/// the norm of what rho lacks after the bound on lengths and the closing of handles
double left_out_share(const CGP::Spin_report& spin)
{
  return (std::max)(spin.missing_share, spin.scales.bound > 0 ? spin.scales.distance() : 0.);
}

void tell_realised_curvature(const CGP::Spin_report& spin, Report& report)
{
  const auto& realised = spin.realised_curvature;
  if (!realised) return;
  const std::string place = "result/realised_curvature/";
  report.set(place + "agreement", realised->agreement());
  report.set(place + "least_agreement", spin.limits.agreement);
  report.set(place + "share", realised->share);
  report.set(place + "correlation", realised->correlation);
  report.set(place + "distance", realised->distance);
  report.set(place + "wrong_sign", realised->wrong_sign);
  report.set(place + "seen_share", realised->seen_share);
  report.set(place + "judged_share", realised->judged_share);
  report.set(place + "left_out", left_out_share(spin));
  report.show(
      "change of curvature, measured (% of rho)",
      text_of(100 * realised->share, 3) + ", correlation " + text_of(realised->correlation, 3));
  report.show("change of curvature of the wrong sign (% of the area)",
              text_of(100 * realised->wrong_sign, 3));
}

void tell_exact_class(const std::optional<CGP::internal::Class_snap_report>& snap, Report& report)
{
  if (!snap) return;
  report.set("result/exact_class/reached", snap->converged);
  report.set("result/exact_class/length_cross_ratio/before", snap->initial_length_cross_ratio.max);
  report.tell("result/exact_class/length_cross_ratio/after",
              "log length cross-ratio change, on the exact class", snap->length_cross_ratio.max, 3);
  report.tell("result/exact_class/displacement", "moved to the exact class by (of the diagonal)",
              snap->displacement, 3);
  report.set("result/exact_class/factorizations", snap->factorizations);
}

/// how the area is distributed over the scales of lengths
void tell_scale(const CGP::internal::Area_distortion& scale, Report& report)
{
  report.set("result/scale/collapsed_share", scale.collapsed_share);
  report.set("result/scale/min", scale.min_scale);
  report.set("result/scale/max", scale.max_scale);
  report.set("result/scale/log_deviation", scale.log_deviation);
  report.set("result/scale/histogram/low", std::exp2(-scale.octaves));
  report.set("result/scale/histogram/high", std::exp2(scale.octaves));
  report.set("result/scale/histogram/share",
             Report::Value(std::vector<double>(scale.histogram.begin(), scale.histogram.end())));
  report.show("scale of lengths", text_of(scale.min_scale) + " to " + text_of(scale.max_scale));
  const auto below = [&](Eigen::Index bins) {
    return text_of(100 * scale.histogram.head(bins).sum(), 3);
  };
  report.show("area scaled by less than 1/4, 1/2, 1, 2, 4 (%)",
              below(4) + ", " + below(6) + ", " + below(8) + ", " + below(10) + ", " + below(12));
}

}  // namespace

void tell_scales(const CGP::Spin_report::Scales& scales, Report& report)
{
  if (scales.bound == 0) return;
  report.set("result/scale_control/bound", scales.bound);
  report.set("result/scale_control/weight", scales.weight);
  report.tell("result/scale_control/low", "lengths scaled by at least (1 % of the area)",
              scales.low, 3);
  report.tell("result/scale_control/high", "lengths scaled by at most (99 %)", scales.high, 3);
  report.set("result/scale_control/tip_low", scales.tip_low);
  report.set("result/scale_control/tip_high", scales.tip_high);
  report.set("result/scale_control/kept_norm", scales.kept_norm);
  report.set("result/scale_control/kept_correlation", scales.kept_correlation);
  if (scales.weight > 0) {
    report.show("kept of rho (% of its norm)", text_of(100 * scales.kept_norm, 3));
    report.show("correlation of what is kept with rho", text_of(scales.kept_correlation, 3));
  }
}

void tell_certificate(const CGP::Spin_report& spin, int faces, Outcome& outcome)
{
  Report& report = outcome.report;
  report.tell("result/eigenvalue", "eigenvalue gamma (1/length)", spin.eigenvalue);
  if (spin.is_relaxed)
    report.show("residual of the Dirac equation (1/length)", text_of(spin.dirac_residual, 3));
  else
    report.tell("result/residual", "residual of the eigenvector", spin.residual, 3);
  if (spin.gap > 0) report.tell("result/gap", "gap to the next eigenvalue", spin.gap);
  const bool has_parts = spin.substeps > 1;
  report.show("iterations",
              std::to_string(spin.iterations) +
                  (has_parts ? " in " + std::to_string(spin.substeps) + " substeps" : ""));
  report.tell("result/closure_residual", "closure residual", spin.closure_residual, 3);
  report.tell("result/min_spin_ratio", "min / max of |lambda|", spin.min_spin_ratio, 3);
  if (spin.missing_share > 0) {
    report.show("realised of rho (% of its norm)", text_of(100 * spin.realised_share, 3));
    report.show("left out of rho, for handles (% of its norm)",
                text_of(100 * spin.missing_share, 3));
  }
  if (spin.added_share > 0)
    report.show("added to rho, to close holes (% of the curvature of a sphere)",
                text_of(100 * spin.added_share, 3));
  tell_scales(spin.scales, report);
  tell_realised_curvature(spin, report);
  tell_exact_class(spin.exact_class, report);
  tell_mollification(spin.mollification, report);
  tell_conformality(spin.conformality, measured_faces(spin, faces), report);
  report_details(spin, report);
  add_seconds(spin, outcome.seconds);
}

void add_seconds(const CGP::Spin_report& spin, Stage_seconds& seconds)
{
  seconds.add("assembly", spin.seconds.assembly);
  seconds.add("factorization", spin.seconds.factorization);
  seconds.add("solve", spin.seconds.eigenvectors);
  seconds.add("exactness", spin.seconds.exactness);
  seconds.add("reconstruction", spin.seconds.reconstruction);
  seconds.add("setup", spin.seconds.setup);
  seconds.add("certificate", spin.seconds.certificate);
}

void tell_conformality(const CGP::Conformality& map, int faces, Report& report)
{
  const auto& Q = map.quasi_conformal;
  const auto& cross_ratio = map.length_cross_ratio;
  report.tell("result/quasi_conformal/mean", "quasi-conformal error, mean", Q.mean);
  report.tell("result/quasi_conformal/p99", "quasi-conformal error, 99 %", Q.p99);
  report.tell("result/quasi_conformal/max", "quasi-conformal error, max", Q.max);
  report.tell("result/length_cross_ratio/rms", "log length cross-ratio change, rms",
              cross_ratio.rms);
  report.tell("result/length_cross_ratio/max", "log length cross-ratio change, max",
              cross_ratio.max);
  report.set("result/quasi_conformal/mean_over_new_area", map.quasi_conformal_of_new_area);
  tell_scale(map.scale, report);
  report.set("result/flipped_faces", map.flipped_faces);
  report.show("flipped faces", std::to_string(map.flipped_faces) + " of " + std::to_string(faces));
}

void tell_mollification(const CGP::Spin_report::Mollification& made, Report& report)
{
  if (made.share == 0) return;
  report.set("result/mollification/share", made.share);
  report.tell("result/mollification/thin_faces", "thin faces", made.thin_faces);
  report.set("result/mollification/longer_edges", made.longer_edges);
  report.set("result/mollification/added_length", made.added_length);
  report.show("edges made longer",
              std::to_string(made.longer_edges) +
                  (made.longer_edges > 0 ? ", each by " + text_of(made.added_length, 3) : ""));
  report.tell("result/mollification/flipped_edges", "edges flipped", made.flipped_edges);
  report.set("result/mollification/measured_faces", made.measured_faces);
  report.set("result/mollification/measured_area", made.measured_area);
  report.show("measured", text_of(100 * made.measured_area, 4) + " % of the area, " +
                              count_of(static_cast<std::size_t>(made.measured_faces), "face"));
}

}  // namespace conformal
