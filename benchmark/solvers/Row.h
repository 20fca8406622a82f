// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "support/Record.h"
#include "support/clock.h"

/// \file The comparison of solvers is a list of rows: one model in one table, measured on one mesh
/// in a separate process, so that rows do not share memory or caches.
namespace cgp_benchmark {

namespace CGP = Conformal_geometry_processing;

/// how to measure a row
struct Job {
  double amplitude = 1;                        ///< of rho, see `smooth_potential()`
  std::optional<double> bound = std::nullopt;  ///< of the factors of lengths
  double tolerance = 1e-6;
  int runs = 5;           ///< the best counts
  double seconds = 20;    ///< no further run begins after as many seconds of the processor
  std::string reference;  ///< the file with the positions that others are compared to
};

struct Row {
  using Measure = void (*)(const Job&, const CGP::Mesh_view&, Record&);

  std::string table, model;
  Measure measure;
  int most_vertices = std::numeric_limits<int>::max();  ///< beyond, the row is left out ...
  std::string reason = "";                              ///< ... because of this
};

/// runs the action as often as the job says, and for a second at least: short ones need more runs
/// until one of them is not disturbed
template <class Action>
void repeat(const Job& job, Action action)
{
  const double begin = cpu_seconds();
  int run = 0;
  double seconds = 0;
  do {
    action();
    ++run;
    seconds = cpu_seconds() - begin;
  } while (seconds < job.seconds && (run < job.runs || seconds < 1));
}

// One function per source file of this folder, which adds its rows.
void add_poisson(std::vector<Row>& rows);
void add_roofline(std::vector<Row>& rows);
void add_native_factors(std::vector<Row>& rows);
void add_other_factors(std::vector<Row>& rows);
void add_native_transforms(std::vector<Row>& rows);
void add_other_transforms(std::vector<Row>& rows);
void add_strengths(std::vector<Row>& rows);
void add_flows(std::vector<Row>& rows);
void add_spectra(std::vector<Row>& rows);
void add_threads(std::vector<Row>& rows);

}  // namespace cgp_benchmark
