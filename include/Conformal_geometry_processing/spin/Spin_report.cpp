// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <algorithm>
#include <cmath>

namespace Conformal_geometry_processing {

const char* to_string(Spin_report::Boundary_fault fault)
{
  switch (fault) {
    case Spin_report::Boundary_fault::not_realizable:
      return "no surface conformally equivalent to this one has this curvature and this boundary";
    case Spin_report::Boundary_fault::does_not_close:
      return "the edges of the new surface do not fit together";
    case Spin_report::Boundary_fault::degenerate:
      return "the new surface shrinks to a point somewhere";
    case Spin_report::Boundary_fault::none:
      break;
  }
  return "none";
}

const char* to_string(Spin_report::Fault fault)
{
  using Fault = Spin_report::Fault;
  switch (fault) {
    case Fault::cancelled:
      return "cancelled";
    case Fault::not_finite:
      return "the eigenvalue is not finite";
    case Fault::not_solved:
      return "the Dirac equation is not solved";
    case Fault::boundary:
      return "the boundary data are not realisable";
    case Fault::directions:
      return "directions at the boundary are missed";
    case Fault::nothing_left:
      return "no part of rho keeps the handles closed";
    case Fault::left_out:
      return "too much of rho is left out";
    case Fault::open:
      return "the edges of the new surface do not close up";
    case Fault::scales:
      return "lengths change by more than the bound";
    case Fault::exact_class:
      return "the exact conformal class is not reached";
    case Fault::unrealised:
      return "the curvature has changed against rho";
    case Fault::map:
      return "the map is not conformal, flips or collapses";
    case Fault::none:
      break;
  }
  return "none";
}

Spin_report::operator bool() const
{
  return fault() == Fault::none;
}

bool Spin_report::falls_short() const
{
  return realised_curvature && !(realised_curvature->agreement() >= limits.agreement);
}

double Spin_report::Scales::excess() const
{
  return bound > 0 ? (std::max)(std::log(high), -std::log(low)) / std::log(bound) : 0;
}

double Spin_report::Scales::distance() const
{
  const double square = 1 + kept_norm * (kept_norm - 2 * kept_correlation);
  return std::sqrt((std::max)(square, 0.));
}

// Comparisons are such that NaN is beyond every limit.
Spin_report::Fault Spin_report::fault() const
{
  if (cancelled) return Fault::cancelled;
  if (steps == 0) return Fault::nothing_left;
  if (!std::isfinite(eigenvalue)) return Fault::not_finite;
  if (!converged || !(is_relaxed || residual <= limits.residual)) return Fault::not_solved;
  const bool is_open = boundary_fault == Boundary_fault::does_not_close;  // judged by its limit
  if (boundary_fault != Boundary_fault::none && !is_open) return Fault::boundary;
  if (!(direction_error.mean <= limits.direction_error)) return Fault::directions;
  if (!(realised_share >= limits.realised_share)) return Fault::left_out;
  if (!(scales.kept_norm >= limits.kept_norm)) return Fault::left_out;
  if (!has_positions && !(closure_residual <= limits.closure)) return Fault::open;
  if (!(period_defect <= period_limit)) return Fault::open;
  const double rounding = 1e-9;
  if (!(scales.excess() <= 1 + rounding)) return Fault::scales;
  if (exact_class && !*exact_class) return Fault::exact_class;
  if (conformality.fault(limits.map) != Conformality::Fault::none) return Fault::map;
  if (realised_curvature && !(realised_curvature->agreement() >= -limits.opposition))
    return Fault::unrealised;
  return Fault::none;
}

namespace internal {

/// of two numbers of which zeros are unknown
double least_known(double a, double b)
{
  return a == 0 || b == 0 ? (std::max)(a, b) : (std::min)(a, b);
}

void append(Spin_report::Mollification& all, const Spin_report::Mollification& next)
{
  const bool is_first = all.share == 0;  // whose faces measure the conformality of the whole path
  if (is_first) all.measured_faces = next.measured_faces;
  if (is_first) all.measured_area = next.measured_area;
  all.share = next.share;
  all.thin_faces = (std::max)(all.thin_faces, next.thin_faces);
  all.longer_edges = (std::max)(all.longer_edges, next.longer_edges);
  all.added_length = (std::max)(all.added_length, next.added_length);
  all.flipped_edges = (std::max)(all.flipped_edges, next.flipped_edges);
}

void add_costs(Spin_report& all, const Spin_report& next)
{
  add_costs(static_cast<Dirac_evidence&>(all), next);
  add_costs(all.seconds, next.seconds);
  all.seconds.exactness += next.seconds.exactness;
  all.seconds.reconstruction += next.seconds.reconstruction;
  all.seconds.certificate += next.seconds.certificate;
}

}  // namespace internal

void append(Spin_report& all, const Spin_report& next)
{
  const Spin_report before = all;
  static_cast<internal::Dirac_evidence&>(all) = next;
  all.residual = (std::max)(before.residual, next.residual);
  all.gap = internal::least_known(before.gap, next.gap);
  all.branch_gap = internal::least_known(before.branch_gap, next.branch_gap);
  if (all.steps > 0) all.overlap = (std::min)(before.overlap, next.overlap);
  all.dirac_residual = (std::max)(before.dirac_residual, next.dirac_residual);
  all.substeps = (std::max)(before.substeps, next.substeps);
  all.steps += next.steps;
  all.direction_error = next.direction_error;
  all.boundary_fault = next.boundary_fault;
  internal::append(all.mollification, next.mollification);
  all.closure_residual = (std::max)(all.closure_residual, next.closure_residual);
  all.period_defect += next.period_defect;
  all.seconds = next.seconds;
  internal::add_costs(all, before);
}

}  // namespace Conformal_geometry_processing
