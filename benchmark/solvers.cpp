// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

/// Compares the models of solvers: factorizations, whole spin transformations, ... and prints one
/// line of JSON per row. Every row is measured in a separate process, together with the
/// yardstick P, one scalar Poisson problem by CHOLMOD; times are processor seconds, the minimum of
/// several runs. `benchmark/performance` calls this program and generates doc/performance.md.
///
/// Usage: benchmark_solvers [OPTION]... [MESH]...
/// A mesh is the frequency f of a bumpy sphere of 20 f^2 faces, a file in the format OFF, or FILE:k
/// with every face of it split in four k times. 20, 41, 81 if none is named.
///   --tables=A,B      these tables only: poisson, factor, transform, ...
///   --models=A;B      these models only
///   --runs=N          N runs of each row, more of those that take less than a second (5)
///   --seconds=S       no further run after S seconds of a row (20)
///   --amplitude=A     of rho (1)
///   --tolerance=T     of the eigenvector (1e-6)
///   --unit=U          SSE2, AVX2, AVX-512 (the widest that there is)
///   --all             also the rows that are left out for their time

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>

#include "solvers/Options.h"
#include "solvers/Row.h"
#include "solvers/processes.h"
#include "support/workloads.h"

namespace {

using namespace cgp_benchmark;

std::vector<Row> all_rows()
{
  std::vector<Row> rows;
  add_poisson(rows);
  add_other_factors(rows);
  add_native_factors(rows);
  add_native_transforms(rows);
  add_strengths(rows);
  add_other_transforms(rows);
  add_flows(rows);
  add_spectra(rows);
  add_threads(rows);
  add_roofline(rows);
  return rows;
}

Record begin_record(const Row& row, const std::string& mesh_name, const CGP::Mesh_view& mesh)
{
  Record record;
  record.add("table", row.table).add("model", row.model);
  record.add("mesh", mesh_name.substr(mesh_name.rfind('/') + 1));
  record.add("faces", mesh.size_of_faces()).add("vertices", mesh.size_of_vertices());
  record.add("unit", CGP::to_string(CGP::vector_unit()));
  return record;
}

int measure_row(const Options& options, const Row& row)
{
  try {
    const CGP::Mesh_view mesh = make_mesh(options.meshes.front());
    Record record = begin_record(row, options.meshes.front(), mesh);
    row.measure(options.job, mesh, record);
    record.print();
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << row.table << ", " << row.model << ": " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}

bool is_named(const std::vector<std::string>& names, const std::string& name)
{
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

/// Measures the row in a separate process, or reports a failure; returns true on success
bool measure_apart(const Options& options, const std::vector<Row>& rows, std::size_t k,
                   const std::string& name, const CGP::Mesh_view& mesh,
                   const std::string& reference)
{
  std::string reason = rows[k].reason;
  if (options.all || mesh.size_of_vertices() <= rows[k].most_vertices) {
    std::vector<std::string> arguments = options.passed_on;
    arguments.insert(arguments.end(),
                     {"--row=" + std::to_string(k), "--reference=" + reference, name});
    reason = run_anew(arguments);
    if (reason.empty()) return true;
  }
  begin_record(rows[k], name, mesh).add("left_out", reason).print();
  return false;
}

/// all rows that are asked for; the reference comes before those that are compared to it
void measure_mesh(const Options& options, const std::vector<Row>& rows, const std::string& name)
{
  const CGP::Mesh_view mesh = make_mesh(name);
  const std::string file = "/tmp/cgp_reference_" + std::to_string(getpid());
  bool has_reference = false;
  for (std::size_t k = 0; k < rows.size(); ++k)
    if (rows[k].table == "reference") {
      if (is_named(options.tables, "transform"))
        has_reference = measure_apart(options, rows, k, name, mesh, file);
    } else if (is_named(options.tables, rows[k].table) && is_named(options.models, rows[k].model)) {
      measure_apart(options, rows, k, name, mesh, has_reference ? file : "");
    }
  std::remove(file.c_str());
}

}  // namespace

int main(int argc, char** argv)
{
  try {
    const Options options = read_options(argc, argv);
    const std::vector<Row> rows = all_rows();
    if (options.row >= 0) return measure_row(options, rows.at(std::size_t(options.row)));
    for (const std::string& name : options.meshes) measure_mesh(options, rows, name);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "benchmark_solvers: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
