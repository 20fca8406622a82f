// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "reports.h"

#include <string>

namespace conformal_python {
namespace {

using namespace pybind11::literals;

py::object text_or_none(bool is_there, const std::string& text)
{
  return is_there ? py::object(py::str(text)) : py::object(py::none());
}

py::dict as_dict(const CGP::internal::Length_cross_ratio_change& c)
{
  return py::dict("rms"_a = c.rms, "max"_a = c.max);
}

py::dict as_dict(const CGP::internal::Area_distortion& a)
{
  py::tuple histogram(a.histogram.size());
  for (Eigen::Index i = 0; i < a.histogram.size(); ++i)
    histogram[static_cast<std::size_t>(i)] = a.histogram[i];
  return py::dict("min_scale"_a = a.min_scale, "max_scale"_a = a.max_scale,
                  "log_deviation"_a = a.log_deviation, "collapsed_share"_a = a.collapsed_share,
                  "histogram"_a = histogram);
}

template <class Error>
py::dict mean_and_max(const Error& e)
{
  return py::dict("mean"_a = e.mean, "max"_a = e.max);
}

py::dict as_dict(const CGP::Spin_report::Mollification& m)
{
  return py::dict("share"_a = m.share, "thin_faces"_a = m.thin_faces,
                  "longer_edges"_a = m.longer_edges, "added_length"_a = m.added_length,
                  "flipped_edges"_a = m.flipped_edges, "measured_faces"_a = m.measured_faces,
                  "measured_area"_a = m.measured_area);
}

py::dict as_dict(const CGP::Spin_report::Scales& s)
{
  return py::dict("bound"_a = s.bound, "low"_a = s.low, "high"_a = s.high, "tip_low"_a = s.tip_low,
                  "tip_high"_a = s.tip_high, "min"_a = s.min, "max"_a = s.max,
                  "weight"_a = s.weight, "kept_norm"_a = s.kept_norm,
                  "kept_correlation"_a = s.kept_correlation);
}

py::dict as_dict(const CGP::Enclosure& e)
{
  return py::dict("area"_a = e.area, "volume"_a = e.volume, "reduced_volume"_a = e.reduced_volume);
}

py::dict as_dict(const CGP::Realised_curvature& r)
{
  return py::dict("share"_a = r.share, "correlation"_a = r.correlation, "distance"_a = r.distance,
                  "wrong_sign"_a = r.wrong_sign, "seen_share"_a = r.seen_share,
                  "judged_share"_a = r.judged_share);
}

py::dict as_dict(const CGP::Spin_report::Seconds& s)
{
  return py::dict("setup"_a = s.setup, "exactness"_a = s.exactness, "assembly"_a = s.assembly,
                  "factorization"_a = s.factorization, "eigenvectors"_a = s.eigenvectors,
                  "reconstruction"_a = s.reconstruction, "certificate"_a = s.certificate);
}

py::dict as_dict(const CGP::Spin_report::Limits& l)
{
  return py::dict(
      "residual"_a = l.residual, "closure"_a = l.closure, "direction_error"_a = l.direction_error,
      "gamma_radius"_a = l.gamma_radius, "realised_share"_a = l.realised_share,
      "kept_norm"_a = l.kept_norm, "agreement"_a = l.agreement, "opposition"_a = l.opposition,
      "quasi_conformal"_a = l.map.quasi_conformal, "flipped_share"_a = l.map.flipped_share,
      "collapsed_share"_a = l.map.collapsed_share);
}

py::dict as_dict(const CGP::Parameterization_report::Seconds& s)
{
  return py::dict("setup"_a = s.setup, "assembly"_a = s.assembly,
                  "factorization"_a = s.factorization, "eigenvector"_a = s.eigenvector,
                  "certificate"_a = s.certificate);
}

/// the verdict, with what it is about in particular
py::object fault_of(const CGP::Spin_report& r)
{
  using Fault = CGP::Spin_report::Fault;
  const Fault fault = r.fault();
  std::string text = to_string(fault);
  if (fault == Fault::boundary) text += std::string(": ") + to_string(r.boundary_fault);
  if (fault == Fault::map)
    text += std::string(": ") + to_string(r.conformality.fault(r.limits.map));
  return text_or_none(fault != Fault::none, text);
}

std::string reason(CGP::Flow_step_report::Stop stop, const std::string& message)
{
  return to_string(stop) + (message.empty() ? "" : ": " + message);
}

py::object as_dict(const CGP::Flow_step_report::Place& place)
{
  if (place.vertex < 0) return py::none();
  return py::dict("vertex"_a = place.vertex, "face"_a = place.face, "angle"_a = place.angle);
}

py::object fault_of(const CGP::Flow_report& r)
{
  if (r) return py::none();
  const std::string words = reason(r.stop, r.message) + to_string(r.place);
  if (!r.has_volume()) return py::str("the prescribed volume is not reached; " + words);
  if (!r.is_complete()) return py::str(words);
  if (r.map_fault() != CGP::Conformality::Fault::none) return py::str(to_string(r.map_fault()));
  return py::str(r.conformal_type_change <= r.max_conformal_type_change
                     ? "the edges have failed to close up around handles and holes"
                     : "the conformal type has changed");
}

}  // namespace

py::dict as_dict(const CGP::internal::Distribution& d)
{
  return py::dict("mean"_a = d.mean, "p99"_a = d.p99, "max"_a = d.max);
}

py::dict as_dict(const CGP::Conformality& c)
{
  return py::dict("quasi_conformal"_a = as_dict(c.quasi_conformal),
                  "quasi_conformal_of_new_area"_a = c.quasi_conformal_of_new_area,
                  "length_cross_ratio"_a = as_dict(c.length_cross_ratio),
                  "scale"_a = as_dict(c.scale), "flipped_faces"_a = c.flipped_faces,
                  "flipped_share"_a = c.flipped_share);
}

py::dict as_dict(const CGP::Spin_report& r)
{
  py::dict d("fault"_a = fault_of(r), "converged"_a = r.converged, "cancelled"_a = r.cancelled,
             "is_relaxed"_a = r.is_relaxed, "is_unfinished"_a = r.is_unfinished,
             "eigenvalue"_a = r.eigenvalue, "residual"_a = r.residual,
             "dirac_residual"_a = r.dirac_residual, "gap"_a = r.gap, "branch_gap"_a = r.branch_gap,
             "overlap"_a = r.overlap, "iterations"_a = r.iterations, "substeps"_a = r.substeps,
             "factorizations"_a = r.factorizations, "solves"_a = r.solves,
             "spectral_shift"_a = r.spectral_shift, "is_generalized"_a = r.is_generalized,
             "generalized_eigenvalue"_a = r.generalized_eigenvalue);
  d["steps"] = r.steps;
  d["reached"] = r.reached;
  d["missing_share"] = r.missing_share;
  d["added_share"] = r.added_share;
  d["period_defect"] = r.period_defect;
  d["realised_share"] = r.realised_share;
  d["direction_error"] = mean_and_max(r.direction_error);
  d["radius"] = r.radius;
  d["limits_gamma"] = r.limits_gamma;
  d["gamma_radius"] = r.gamma_radius();
  using Fault = CGP::Spin_report::Boundary_fault;
  d["boundary_fault"] = text_or_none(r.boundary_fault != Fault::none, to_string(r.boundary_fault));
  d["has_positions"] = r.has_positions;
  d["position_error"] = mean_and_max(r.position_error);
  d["mollification"] = as_dict(r.mollification);
  d["scales"] = as_dict(r.scales);
  d["realised_curvature"] =
      r.realised_curvature ? py::object(as_dict(*r.realised_curvature)) : py::object(py::none());
  d["exact_class"] = r.exact_class ? py::object(as_dict(*r.exact_class)) : py::object(py::none());
  d["closure_residual"] = r.closure_residual;
  d["conformality"] = as_dict(r.conformality);
  d["min_spin_ratio"] = r.min_spin_ratio;
  d["collar"] = r.collar ? py::object(as_dict(*r.collar)) : py::object(py::none());
  d["seconds"] = as_dict(r.seconds);
  d["limits"] = as_dict(r.limits);
  return d;
}

py::dict as_dict(const CGP::Flow_step_report& r)
{
  using Stop = CGP::Flow_step_report::Stop;
  py::dict d(
      "step"_a = r.step, "accepted"_a = r.accepted,
      "stop"_a = text_or_none(r.stop != Stop::none, to_string(r.stop)), "message"_a = r.message,
      "place"_a = as_dict(r.place), "energy_before"_a = r.energy_before, "energy"_a = r.energy,
      "energy_of_faces"_a = r.energy_of_faces, "is_bounded"_a = r.is_bounded, "faired"_a = r.faired,
      "time_step"_a = r.time_step, "trials"_a = r.trials, "direction_norm"_a = r.direction_norm,
      "direction_norm_after"_a = r.direction_norm_after, "remaining_share"_a = r.remaining_share,
      "period_defect"_a = r.period_defect, "spin"_a = as_dict(r.spin),
      "quasi_conformal"_a = as_dict(r.quasi_conformal),
      "length_cross_ratio"_a = r.length_cross_ratio, "seconds"_a = r.seconds);
  return d;
}

py::dict as_dict(const CGP::Flow_report& r)
{
  py::list steps;
  for (const CGP::Flow_step_report& step : r.steps) steps.append(as_dict(step));
  return py::dict(
      "fault"_a = fault_of(r), "stop"_a = to_string(r.stop), "converged"_a = r.converged(),
      "message"_a = r.message, "place"_a = as_dict(r.place), "steps"_a = steps,
      "initial_energy"_a = r.initial_energy, "energy"_a = r.energy,
      "initial_energy_of_faces"_a = r.initial_energy_of_faces,
      "energy_of_faces"_a = r.energy_of_faces, "conformality"_a = as_dict(r.conformality),
      "conformality_of_faces"_a = as_dict(r.conformality_of_faces),
      "initial_enclosure"_a = as_dict(r.initial_enclosure), "enclosure"_a = as_dict(r.enclosure),
      "missing_volume"_a = r.missing_volume, "direction_norm"_a = r.direction_norm,
      "scales"_a = as_dict(r.scales), "bounded_steps"_a = r.bounded_steps,
      "conformal_type_change"_a = r.conformal_type_change, "period_defect"_a = r.period_defect,
      "seconds"_a = r.seconds);
}

py::dict as_dict(const CGP::Parameterization_report& r)
{
  return py::dict("fault"_a = text_or_none(!r, "the eigenvector has not converged"),
                  "converged"_a = r.converged, "eigenvalue"_a = r.eigenvalue,
                  "next_eigenvalue"_a = r.next_eigenvalue, "residual"_a = r.residual,
                  "iterations"_a = r.iterations, "boundary_loops"_a = r.boundary_loops,
                  "normalized_vertices"_a = r.normalized_vertices,
                  "conformality"_a = as_dict(r.conformality),
                  "uniform_quasi_conformal"_a = as_dict(r.uniform_quasi_conformal),
                  "overlap"_a = py::dict("faces"_a = r.overlap.faces, "share"_a = r.overlap.share),
                  "seconds"_a = as_dict(r.seconds));
}

py::dict as_dict(const CGP::internal::Class_snap_report& r)
{
  return py::dict("fault"_a = text_or_none(!r, "the surface is too far from the conformal class"),
                  "converged"_a = r.converged, "iterations"_a = r.iterations,
                  "factorizations"_a = r.factorizations,
                  "initial_length_cross_ratio"_a = as_dict(r.initial_length_cross_ratio),
                  "length_cross_ratio"_a = as_dict(r.length_cross_ratio),
                  "displacement"_a = r.displacement);
}

}  // namespace conformal_python
