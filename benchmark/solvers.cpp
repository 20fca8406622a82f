// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later

/// Compares the models of solvers: factorizations, whole spin transformations, ... and prints one
/// line of JSON per row. Every row is measured in a process of its own, together with the
/// yardstick P, one scalar Poisson problem by CHOLMOD; times are seconds of the processor, the best
/// of several runs. `benchmark/performance` calls this and makes doc/performance.md of it.
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
  add_other_transforms(rows);
  return rows;
}

/// the registers that the kernels are compiled for
const char* simd()
{
#if defined(__AVX512F__)
  return "AVX-512";
#elif defined(__AVX2__)
  return "AVX2";
#elif defined(__SSE2__)
  return "SSE2";
#else
  return "others";
#endif
}

Record begin_record(const Row& row, const std::string& mesh_name, const CGP::Mesh_view& mesh)
{
  Record record;
  record.add("table", row.table).add("model", row.model);
  record.add("mesh", mesh_name.substr(mesh_name.rfind('/') + 1));
  record.add("faces", mesh.size_of_faces()).add("vertices", mesh.size_of_vertices());
  record.add("simd", simd());
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

void measure_mesh(const Options& options, const std::vector<Row>& rows, const std::string& name)
{
  const CGP::Mesh_view mesh = make_mesh(name);
  const std::string reference = "/tmp/cgp_reference_" + std::to_string(getpid());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Row& row = rows[k];
    const bool is_reference = row.table == "reference";
    if (!is_named(options.tables, is_reference ? "transform" : row.table)) continue;
    if (!is_reference && !is_named(options.models, row.model)) continue;
    if (mesh.size_of_vertices() > row.most_vertices && !options.all) {
      begin_record(row, name, mesh).add("left_out", row.reason).print();
      continue;
    }
    std::vector<std::string> arguments = options.passed_on;
    arguments.insert(arguments.end(),
                     {"--row=" + std::to_string(k), "--reference=" + reference, name});
    const std::string failure = run_anew(arguments);
    if (!failure.empty()) begin_record(row, name, mesh).add("left_out", failure).print();
  }
  std::remove(reference.c_str());
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
