// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace Conformal_geometry_processing {

const char* to_string(Spin_report::Boundary_fault fault)
{
  switch (fault) {
    case Spin_report::Boundary_fault::not_realizable:
      return "no surface conformally equivalent to this one has this curvature and this boundary";
    case Spin_report::Boundary_fault::does_not_close:
      return "the edges of the new surface do not fit together";
    case Spin_report::Boundary_fault::ambiguous:
      return "two surfaces have this boundary, and the mesh is too coarse around a hole to tell "
             "which";
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
    case Fault::curvature:
      return "the mean curvature is another one than rho says";
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
  if (!(bound > 0)) return 0;
  const double of_most = (std::max)(std::log(high), -std::log(low)) / std::log(bound);
  const double of_tips =
      (std::max)(std::log(tip_high), -std::log(tip_low)) / std::log(wider_at_tips * bound);
  return (std::max)(of_most, of_tips);
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
  if (limits_gamma && !(std::abs(gamma_radius()) <= limits.gamma_radius)) return Fault::curvature;
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
  all.radius = next.radius;
  all.limits_gamma = next.limits_gamma;
  all.boundary_fault = next.boundary_fault;
  internal::append(all.mollification, next.mollification);
  all.closure_residual = (std::max)(all.closure_residual, next.closure_residual);
  all.period_defect += next.period_defect;
  all.seconds = next.seconds;
  internal::add_costs(all, before);
}

namespace internal {

/// the fault in words, and which of the faults of its kind it is
std::string reason_of(const Spin_report& r)
{
  const Spin_report::Fault fault = r.fault();
  const std::string reason = to_string(fault);
  if (fault == Spin_report::Fault::boundary) return reason + ": " + to_string(r.boundary_fault);
  if (fault == Spin_report::Fault::map)
    return reason + ": " + to_string(r.conformality.fault(r.limits.map));
  return reason;
}

}  // namespace internal

std::ostream& operator<<(std::ostream& out, const Spin_report& r)
{
  const char* const failed = r.cancelled ? "cancelled" : "NOT solved";
  const char* const solved = r.is_relaxed ? "relaxed" : "solved";
  out << "Dirac equation         " << (r.converged ? solved : failed) << ", residual "
      << (r.is_relaxed ? r.dirac_residual : r.residual) << " after " << r.iterations
      << " iterations";
  if (r.substeps > 1) out << " in " << r.substeps << " substeps";
  out << ", " << r.factorizations << " factorizations";
  out << (r.is_relaxed ? "\ngamma                  " : "\neigenvalue             ") << r.eigenvalue
      << " (";
  if (r.gap > 0) out << "next one " << r.gap << " away, ";
  out << "overlap with the identity " << r.overlap << ")\n"
      << "closure                " << r.closure_residual << " of the edge lengths\n";
  if (r.steps != 1 || r.missing_share > 0)
    out << "handles kept closed    " << 100 * r.reached << " % of the way, "
        << 100 * r.realised_share << " % of rho realised and " << 100 * r.missing_share
        << " % left out, by norm\n";
  if (r.added_share > 0)
    out << "added to close holes   a rho of " << 100 * r.added_share
        << " % of the curvature of a sphere\n";
  if (r.scales.bound > 0)
    out << "scale control          98 % of the area scaled by " << r.scales.low << " to "
        << r.scales.high << ", tips by " << r.scales.tip_low << " to " << r.scales.tip_high
        << ", with a bound of " << r.scales.bound << ", " << 100 * r.scales.kept_norm
        << " % of rho kept, correlation " << r.scales.kept_correlation << '\n';
  if (r.exact_class)
    out << "exact conformal class  " << (r.exact_class->converged ? "reached" : "NOT reached")
        << ", length cross-ratios kept to " << r.exact_class->length_cross_ratio.max
        << ", before to " << r.exact_class->initial_length_cross_ratio.max << ", "
        << r.exact_class->factorizations << " factorizations\n";
  if (r.mollification.share > 0)
    out << "mollification          " << r.mollification.thin_faces << " thin faces, "
        << r.mollification.longer_edges << " edges longer by " << r.mollification.added_length
        << ", " << r.mollification.flipped_edges << " flips, "
        << 100 * r.mollification.measured_area << " % of the area measured\n";
  if (r.direction_error.max > 0)
    out << "directions             missed by " << r.direction_error.mean << " radians in the mean, "
        << r.direction_error.max << " at most\n";
  if (r.limits_gamma) out << "gamma times the radius " << r.gamma_radius() << '\n';
  if (r.position_error.max > 0)
    out << "positions              missed by " << r.position_error.mean << " in the mean, "
        << r.position_error.max << " at most\n";
  if (r.collar)
    out << "collar                 quasi-conformal error " << r.collar->quasi_conformal.mean
        << " in the mean, " << r.collar->quasi_conformal.max << " at most\n";
  if (const auto& realised = r.realised_curvature)
    out << "change of curvature    " << 100 * realised->share << " % of rho, correlation "
        << realised->correlation << ", wrong sign on " << 100 * realised->wrong_sign
        << " % of the area, distance " << realised->distance << '\n';
  internal::print_conformality(out, r.conformality);
  return out << "fault                  " << internal::reason_of(r) << '\n';
}

Points rotated_normals(const Mesh_view& mesh, const Quaternion_vector<double>& lambda)
{
  Points normals(3, mesh.size_of_faces());
  internal::for_each_index(mesh.size_of_faces(), 1024, [&](int f) {
    const auto& v = mesh.corners(f);
    normals.col(f) = spin(lambda[v[0]] + lambda[v[1]] + lambda[v[2]], mesh.double_area_vector(f));
  });
  return normals;
}

namespace internal {

void certify(const Mesh_view& measured, const Points& f, const Quaternion_vector<double>& lambda,
             Spin_report& report, const Surface_part& part)
{
  report.conformality = measured_conformality(measured, f, rotated_normals(measured, lambda), part);
  const Eigen::VectorXd size =
      components(lambda).colwise().norm().head(part.own_vertices(lambda.size())).transpose();
  report.min_spin_ratio = part.smallest(size) / part.largest(size);
  report.converged = report.converged && part.sum(f.allFinite() ? 0 : 1) == 0;
}

}  // namespace internal

double internal::radius_of_area(const Surface_ref& surface, const Surface_part& part)
{
  const Eigen::VectorXd areas = face_areas(surface);
  return std::sqrt(part.sum(areas.head(part.own_faces(areas.size())).sum()) / std::acos(-1.));
}

double greatest_misfit(const Surface_ref& surface, const internal::Surface_part& part)
{
  const double radius = internal::radius_of_area(surface, part);
  return (std::max)(0.05, 3 * mean_edge_length(surface, part) / radius) / radius;
}

double greatest_zero(const Surface_ref& surface)
{
  const double radius = internal::radius_of_area(surface);
  return (std::max)(0.05, mean_edge_length(surface) / radius) / radius;
}

Spin_report::Boundary_fault boundary_fault(const Surface_ref& surface, double sigma,
                                           const Spin_report& report,
                                           const internal::Surface_part& part)
{
  const double radius = internal::radius_of_area(surface, part), small_gap = 0.01;
  const double h = mean_edge_length(surface, part) / radius, great_misfit = 0.15;
  const double closing = report.closure_residual;
  if (sigma > greatest_misfit(surface, part) &&
      (closing > small_gap || sigma * radius > great_misfit))
    return Spin_report::Boundary_fault::not_realizable;
  if (!report.has_positions && closing > (std::max)(report.limits.closure, 3 * h * h))
    return Spin_report::Boundary_fault::does_not_close;
  if (report.min_spin_ratio < 0.02) return Spin_report::Boundary_fault::degenerate;
  return Spin_report::Boundary_fault::none;
}

}  // namespace Conformal_geometry_processing
