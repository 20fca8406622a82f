// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <stdexcept>

#include "Row.h"
#include "positions_file.h"
#include "support/Cholmod_poisson.h"
#include "support/memory.h"
#include "support/workloads.h"

/// The table of whole transformations: from the arrays of the mesh to the new positions and their
/// report, the first one on a mesh.
namespace cgp_benchmark {

/// \brief measures `transform()`, which returns positions; its first run is the one whose memory
/// counts, for nothing has been touched then.
template <class Transform>
void measure_whole(const Job& job, const CGP::Mesh_view& mesh, Record& record, Transform transform)
{
  CGP::Points positions;
  double seconds = never, wall = never;
  Poisson_seconds floor;
  const auto run = [&] {
    const double begin = wall_seconds();
    keep_least(seconds, [&] { positions = transform(); });
    wall = std::min(wall, wall_seconds() - begin);
  };
  const double bytes = peak_bytes(run);
  repeat(job, [&] {
    floor.measure(mesh);
    run();
  });
  record.add("seconds", seconds).add("wall", wall).add("bytes", bytes);
  record.add("poisson", floor.total);
  if (!job.reference.empty())
    record.add("difference", CGP::align(positions, read_positions(job.reference)).max);
}

/// the share of every stage in the whole
inline void add_stages(const CGP::Spin_report& report, Record& record)
{
  const auto& s = report.seconds;
  const double whole = s.setup + s.exactness + s.assembly + s.factorization + s.eigenvectors +
                       s.reconstruction + s.certificate;
  record.add("setup_share", s.setup / whole).add("exactness_share", s.exactness / whole);
  record.add("assembly_share", s.assembly / whole);
  record.add("factorization_share", s.factorization / whole);
  record.add("eigenvectors_share", s.eigenvectors / whole);
  record.add("reconstruction_share", s.reconstruction / whole);
  record.add("certificate_share", s.certificate / whole);
}

template <class SolverTraits, class EigensolverTraits = CGP::Lobpcg_eigensolver_traits>
void measure_transform(const Job& job, const CGP::Mesh_view& mesh, Record& record)
{
  const CGP::Curvature_potential rho = smooth_potential(mesh, job.amplitude);
  CGP::Spin_transformation_options control;
  control.scales.bound = job.bound;
  control.dirac.tolerance = job.tolerance;
  control.dirac.eigensolver = EigensolverTraits();
  control.solvers = SolverTraits();
  CGP::Spin_report report;
  measure_whole(job, mesh, record, [&] {
    CGP::Spin_result result = CGP::Spin_transformation(mesh, control).transform(rho);
    report = result.report;
    return std::move(result.positions);
  });
  record.add("iterations", report.iterations).add("substeps", report.substeps);
  record.add("factorizations", report.factorizations).add("solves", report.solves);
  record.add("converged", report.converged ? 1 : 0).add("fault", to_string(report.fault()));
  if (job.bound) record.add("kept", report.scales.kept_norm);
  add_stages(report, record);
}

}  // namespace cgp_benchmark
