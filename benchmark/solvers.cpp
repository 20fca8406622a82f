// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later

/// Measures the models of SparseHermitianSolver on the matrices of a spin transformation and prints
/// a Markdown table per mesh: CPU time of the whole process, the least of several runs, so that the
/// ratios within one run mean something on a busy machine.
///
/// Usage: benchmark_solvers [--metis] [--runs=N] [frequency or OFF file]...
/// A number f is a bumpy geodesic sphere of 20 f^2 faces; 20, 41, 81 if nothing is named. Set
/// OPENBLAS_NUM_THREADS=1 for figures of one thread.

#include <Conformal_geometry_processing/linear_algebra/Eigen_hermitian_solver_traits.h>
#include <Conformal_geometry_processing/linear_algebra/Supernodal_cholesky.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/mass_matrices.h>

#ifdef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
#include <Conformal_geometry_processing/linear_algebra/Cholmod_hermitian_solver_traits.h>
#endif

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/spheres.h"

namespace {

namespace CGP = Conformal_geometry_processing;
using Quaternion = CGP::Quaternion<double>;
using Pattern = std::shared_ptr<const CGP::Sparse_pattern>;

struct Options {
  int runs = 5;
  bool metis = false;
  std::vector<std::string> meshes;
};

double cpu_seconds()
{
  std::timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

template <class Action>
void keep_least(double& seconds, Action action)
{
  const double begin = cpu_seconds();
  action();
  seconds = std::min(seconds, cpu_seconds() - begin);
}

void require(CGP::Solver_status status)
{
  if (status != CGP::Solver_status::success) throw std::runtime_error(CGP::to_string(status));
}

// ------------------------------------------------------------------------------------- meshes

CGP::Mesh_view bumpy_geodesic_sphere(int frequency)
{
  return cgp_test::mapped(cgp_test::geodesic_sphere(frequency), [](const Eigen::Vector3d& p) {
    const double bump = std::sin(5 * p.x() + 1) * std::sin(4 * p.y() + 2) +
                        0.7 * std::sin(6 * p.z() + 3 * p.x()) +
                        0.5 * std::sin(9 * p.y() - 4 * p.z());
    return Eigen::Vector3d((1 + 0.1 * bump) * p);
  });
}

/// a triangle mesh in the format OFF, without the vertices that no face has
CGP::Mesh_view read_off(const std::string& path)
{
  std::ifstream file(path);
  std::stringstream words;
  for (std::string line; std::getline(file, line);) words << line.substr(0, line.find('#')) << '\n';
  std::string magic;
  int vertices = 0, faces = 0, edges = 0;
  words >> magic >> vertices >> faces >> edges;
  if (!words || magic != "OFF") throw std::runtime_error(path + " is no OFF file");
  CGP::Points points(3, vertices);
  for (int v = 0; v < vertices; ++v) words >> points(0, v) >> points(1, v) >> points(2, v);
  CGP::Mesh_view::Corners corners(static_cast<std::size_t>(faces));
  std::vector<int> number(static_cast<std::size_t>(vertices), -1);
  int used = 0;
  for (auto& face : corners) {
    int degree = 0;
    words >> degree;
    for (int& v : face) {
      words >> v;
      int& n = number.at(static_cast<std::size_t>(v));
      if (n < 0) n = used++;
    }
    if (!words || degree != 3) throw std::runtime_error(path + " is no triangle mesh");
  }
  CGP::Points compact(3, used);
  for (int v = 0; v < vertices; ++v)
    if (const int n = number[static_cast<std::size_t>(v)]; n >= 0) compact.col(n) = points.col(v);
  for (auto& face : corners)
    for (int& v : face) v = number[static_cast<std::size_t>(v)];
  return {std::move(compact), std::move(corners)};
}

CGP::Mesh_view make_mesh(const std::string& name)
{
  const bool is_number = name.find_first_not_of("0123456789") == std::string::npos;
  const CGP::Mesh_view mesh = is_number ? bumpy_geodesic_sphere(std::stoi(name)) : read_off(name);
  return cgp_test::scaled_to_area(mesh, 4 * cgp_test::pi);
}

// ----------------------------------------------------------------------------------- measuring

constexpr double never = std::numeric_limits<double>::infinity();

struct Row {
  std::string model;
  double symbolic = never, numeric = never, again = never, solve = never, bytes = 0, residual = 0;
};

template <class Scalar>
double relative_residual(const CGP::Hermitian_sparse_matrix<Scalar>& A,
                         const Eigen::VectorXd& shift, const CGP::Block<Scalar>& x,
                         const CGP::Block<Scalar>& b)
{
  double error = 0, size = 0;
  for (Eigen::Index c = 0; c < b.cols(); ++c) {
    const CGP::Vector<Scalar> Ax = A * x.col(c);
    for (Eigen::Index i = 0; i < b.rows(); ++i) {
      const Scalar r = Ax[i] + shift[i] * x(i, c) - b(i, c);
      error += CGP::Scalar_traits<Scalar>::real(CGP::conjugate(r) * r);
      size += CGP::Scalar_traits<Scalar>::real(CGP::conjugate(b(i, c)) * b(i, c));
    }
  }
  return std::sqrt(error / size);
}

template <class Scalar>
CGP::Block<Scalar> right_hand_sides(int rows)
{
  CGP::Block<Scalar> b(rows, std::is_same_v<Scalar, double> ? 3 : 1);
  for (Eigen::Index c = 0; c < b.cols(); ++c)
    for (int i = 0; i < rows; ++i)
      b(i, c) = CGP::Scalar_traits<Scalar>::from_real(std::sin(1. + i * double(c + 1)));
  return b;
}

/// one quaternion, or three numbers, per vertex on the right-hand side
template <class Solver>
Row measure(const std::string& model,
            const CGP::Hermitian_sparse_matrix<typename Solver::Scalar>& A,
            const Eigen::VectorXd& shift, const CGP::Ordering& order, int runs)
{
  using Scalar = typename Solver::Scalar;
  const auto b = right_hand_sides<Scalar>(A.size());
  CGP::Block<Scalar> x;
  Row row;
  row.model = model;
  for (int run = 0; run < runs; ++run) {
    Solver solver;
    keep_least(row.symbolic, [&] { require(solver.analyze(A.pattern(), order)); });
    keep_least(row.numeric, [&] { require(solver.factorize(A, shift)); });
    for (int i = 0; i < 2; ++i) keep_least(row.again, [&] { require(solver.factorize(A, shift)); });
    for (int i = 0; i < 3; ++i) keep_least(row.solve, [&] { require(solver.solve(b, x)); });
    row.bytes = solver.statistics().bytes / A.size();
  }
  row.residual = relative_residual(A, shift, x, b);
  return row;
}

#ifdef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
/// the nested dissection of METIS, by way of CHOLMOD
CGP::Ordering metis_ordering(const CGP::Sparse_pattern& pattern)
{
  cholmod_common common;
  cholmod_start(&common);
  cholmod_sparse graph{};
  graph.nrow = graph.ncol = static_cast<std::size_t>(pattern.size());
  graph.nzmax = pattern.indices.size();
  graph.p = const_cast<int*>(pattern.offsets.data());
  graph.i = const_cast<int*>(pattern.indices.data());
  graph.stype = -1;
  graph.itype = CHOLMOD_INT;
  graph.xtype = CHOLMOD_PATTERN;
  graph.sorted = graph.packed = 1;
  CGP::Ordering order(graph.nrow);
  const bool is_done = cholmod_metis(&graph, nullptr, 0, 1, order.data(), &common) != 0;
  cholmod_finish(&common);
  if (!is_done) throw std::runtime_error("METIS failed");
  return order;
}
#endif

CGP::Ordering find_ordering(const CGP::Sparse_pattern& pattern, bool metis)
{
  if (!metis) return CGP::amd_ordering(pattern);
#ifdef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
  return metis_ordering(pattern);
#else
  throw std::runtime_error("--metis needs CHOLMOD");
#endif
}

std::vector<Row> measure_all(const CGP::Mesh_view& mesh, const CGP::Ordering& order, int runs)
{
  const Pattern pattern = CGP::vertex_graph(mesh);
  const Eigen::VectorXd shift = 1e-3 * CGP::vertex_areas(mesh);
  const auto X = CGP::dirac_energy(
      mesh, CGP::Curvature_potential::on_vertices(cgp_test::rho_of_section_3_on_vertices(mesh)));
  const auto L = CGP::cotan_laplacian(mesh);
  std::vector<Row> rows;
#ifdef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
  using Cholmod = CGP::Cholmod_hermitian_solver_traits;
  rows.push_back(measure<Cholmod::Solver<double>>("CHOLMOD, real n", L, shift, order, runs));
#endif
  rows.push_back(
      measure<CGP::Supernodal_cholesky<double>>("native, real n", L, shift, order, runs));
  rows.push_back(measure<CGP::Supernodal_cholesky<double, float>>("native, real n in float", L,
                                                                  shift, order, runs));
  rows.push_back(
      measure<CGP::Supernodal_cholesky<Quaternion>>("native, quaternion n", X, shift, order, runs));
  rows.push_back(measure<CGP::Supernodal_cholesky<Quaternion, float>>(
      "native, quaternion n in float", X, shift, order, runs));
#ifdef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
  rows.push_back(
      measure<Cholmod::Solver<Quaternion>>("CHOLMOD, complex 2n", X, shift, order, runs));
#endif
  if (mesh.size_of_vertices() <= 20000)
    rows.push_back(measure<CGP::Eigen_hermitian_solver_traits::Solver<Quaternion>>(
        "Eigen, complex 2n", X, shift, order, 1));
  return rows;
}

// ------------------------------------------------------------------------------------ printing

void print(const std::string& name, const CGP::Mesh_view& mesh, double ordering,
           const std::vector<Row>& rows)
{
  const Row& floor = rows.front();
  std::printf("\n**%s**: %d faces, %d vertices; ordering %.2f ms; ratios to %s\n\n", name.c_str(),
              mesh.size_of_faces(), mesh.size_of_vertices(), 1e3 * ordering, floor.model.c_str());
  std::printf(
      "| model | symbolic ms | numeric ms | again ms | ratio | solve ms | ratio | bytes/vertex | "
      "residual |\n|---|---|---|---|---|---|---|---|---|\n");
  for (const Row& r : rows)
    std::printf("| %s | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f | %.0f | %.0e |\n", r.model.c_str(),
                1e3 * r.symbolic, 1e3 * r.numeric, 1e3 * r.again, r.again / floor.again,
                1e3 * r.solve, r.solve / floor.solve, r.bytes, r.residual);
  std::fflush(stdout);
}

Options read_options(int argc, char** argv)
{
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--metis")
      options.metis = true;
    else if (word.rfind("--runs=", 0) == 0)
      options.runs = std::stoi(word.substr(7));
    else
      options.meshes.push_back(word);
  }
  if (options.meshes.empty()) options.meshes = {"20", "41", "81"};
  return options;
}

}  // namespace

int main(int argc, char** argv)
{
  const Options options = read_options(argc, argv);
  for (const std::string& name : options.meshes) {
    const CGP::Mesh_view mesh = make_mesh(name);
    CGP::Ordering order;
    double seconds = never;
    keep_least(seconds, [&] { order = find_ordering(*CGP::vertex_graph(mesh), options.metis); });
    print(name, mesh, seconds, measure_all(mesh, order, options.runs));
  }
}
