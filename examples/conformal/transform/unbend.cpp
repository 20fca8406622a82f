// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "unbend.h"

#include "conformal/process/interruption.h"

#include <Conformal_geometry_processing/parameterization/normalized_boundary.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Conformal_geometry_processing/surfaces/minimal_surface.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <algorithm>
#include <optional>

namespace conformal {
namespace {

constexpr double flat = 0.05;  // of the diameter: the projection to the plane then changes little
constexpr double least_share = 1. / 16;
constexpr int most_trials = 40;

double height(const CGP::Points& positions)
{
  const Eigen::Vector3d extent = positions.rowwise().maxCoeff() - positions.rowwise().minCoeff();
  return extent.z() / extent.head<2>().norm();
}

bool is_good(const CGP::Spin_result& there, double closure)
{
  const CGP::Spin_report& report = there.report;
  return report.converged && there.positions.allFinite() && report.closure_residual <= closure &&
         report.conformality.flipped_faces == 0;
}

/// none where a matrix is singular
std::optional<CGP::Spin_result> step(const CGP::Mesh_view& mesh, double share,
                                     const CGP::Spin_transformation_options& own)
{
  throw_if_interrupted();
  try {
    return CGP::internal::spin_towards_minimal_surface(mesh, share, own, "flatten",
                                                       CGP::internal::Always_go_further());
  } catch (const CGP::Solver_error&) {
    return std::nullopt;
  }
}

}  // namespace

bool Unbent_surface::is_flat() const
{
  return height <= flat;
}

// Whether the next surface is a minimal one with these tangents to a tolerance says little about
// whether it is nearer to the plane, so `Spin_report::Boundary_fault` does not count here.
Unbent_surface unbend(const CGP::Mesh_view& mesh, double closure)
{
  CGP::Spin_transformation_options own{
      CGP::Boundary_condition::tangents(CGP::planar_directions(mesh))};
  own.exactness = std::nullopt;
  own.dirac.branch = CGP::Dirac_options::Branch::zero;
  Unbent_surface unbent;
  unbent.result.positions = mesh.positions();
  CGP::Mesh_view present = mesh;
  double share = 1;
  for (int k = 0; k < most_trials && share >= least_share && !unbent.is_flat(); ++k) {
    const std::optional<CGP::Spin_result> next = step(present, share, own);
    const bool is_taken = next && is_good(*next, closure);
    if (is_taken || (next && k == 0)) {
      const CGP::Spin_report before = unbent.result.report;
      unbent.result = *next;
      CGP::internal::add_costs(unbent.result.report, before);
    }
    if (is_taken) {
      present = CGP::Mesh_view(unbent.result.positions, mesh.corners());
      unbent.height = height(unbent.result.positions);
      ++unbent.steps;
    }
    share = is_taken ? (std::min)(1., 2 * share) : share / 2;
  }
  unbent.result.report.steps = unbent.steps;
  unbent.result.report.boundary_fault = CGP::Spin_report::Boundary_fault::none;
  return unbent;
}

}  // namespace conformal
