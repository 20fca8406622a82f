// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/Supernodal_cholesky.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <string>

#include "factors.h"
#include "transforms.h"

/// The table of threads: the same with one and with two, wall clock.
namespace cgp_benchmark {

template <class Action>
static void compare_threads(const Job& job, Record& record, Action action)
{
  double wall[] = {never, never};
  repeat(job, [&] {
    for (const int threads : {1, 2}) {
      CGP::set_number_of_threads(threads);
      const double begin = wall_seconds();
      action();
      wall[threads - 1] = std::min(wall[threads - 1], wall_seconds() - begin);
    }
  });
  record.add("wall_1", wall[0]).add("wall_2", wall[1]);
}

static void measure_numeric(const Job& job, const CGP::Mesh_view& mesh, Record& record)
{
  using Quaternion = CGP::Quaternion<double>;
  const auto X = matrix_of<Quaternion>(job, mesh);
  const Eigen::VectorXd shift = 1e-3 * CGP::vertex_areas(mesh);
  CGP::Supernodal_cholesky<Quaternion> solver;
  require(solver.analyze_with_positions(X.pattern(), mesh.positions()));
  require(solver.factorize(X, shift));
  compare_threads(job, record, [&] { require(solver.factorize(X, shift)); });
}

static void measure_whole_transformation(const Job& job, const CGP::Mesh_view& mesh, Record& record)
{
  const CGP::Curvature_potential rho = smooth_potential(mesh, job.amplitude);
  CGP::Spin_transformation_options options;
  options.dirac.tolerance = job.tolerance;
  compare_threads(job, record, [&] {
    if (!CGP::Spin_transformation(mesh, options).transform(rho).report)
      throw std::runtime_error("no convergence");
  });
}

void add_threads(std::vector<Row>& rows)
{
  rows.push_back({"threads", "numeric", measure_numeric, 600'000, "takes minutes"});
  rows.push_back({"threads", "whole", measure_whole_transformation, 600'000, "takes minutes"});
}

}  // namespace cgp_benchmark
