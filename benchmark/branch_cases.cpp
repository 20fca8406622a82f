// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// How do results change with the amplitude of rho, and with a constant added to it? What lies next
// to shifts of the spectrum that are eigenvalues? Prints a line of JSON for each amplitude of each
// mesh, and one for each shift.
//
// usage: benchmark_branch_cases NAME.off ...
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin/Dirac_spectrum.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <string>
#include <vector>

#include "support/Off_file.h"
#include "support/Record.h"
#include "support/fibonacci_sphere.h"
#include "support/potentials.h"
#include "support/torus_spectrum.h"

namespace {

using namespace cgp_benchmark;
using CGP::Points;
using Rho = CGP::Curvature_potential;

/// the root of the mean square of distances, relative to the diagonal
double distance(const CGP::Mesh_view& mesh, const Points& f, const Points& g)
{
  const Eigen::VectorXd areas = CGP::vertex_areas(mesh);
  const Points& p = mesh.positions();
  const double diagonal = (p.rowwise().maxCoeff() - p.rowwise().minCoeff()).norm();
  const Eigen::VectorXd squares = (f - g).colwise().squaredNorm();
  return std::sqrt(areas.dot(squares) / areas.sum()) / diagonal;
}

CGP::Spin_result transformed(CGP::Spin_transformation& transformation, Rho rho, double constant)
{
  transformation.dirac().tolerance = 1e-10;
  rho.values.array() += constant;
  return transformation.transform(rho);
}

void sweep(const std::string& path)
{
  const CGP::Mesh_view mesh = normalized(read_off(path));
  CGP::require_surface(mesh, "benchmark_branch_cases");
  CGP::require_closed(mesh, "benchmark_branch_cases");
  CGP::Spin_transformation transformation(mesh);
  const int n = 40;
  Points last = mesh.positions();
  for (int k = 1; k <= n; ++k) {
    const double amplitude = 3. * k / n;
    const Rho rho = sampled(mesh, potentials[0], amplitude);
    const CGP::Spin_result r = transformed(transformation, rho, 0);
    Record record;
    record.add("mesh", path.substr(path.find_last_of('/') + 1))
        .add("faces", mesh.size_of_faces())
        .add("amplitude", amplitude)
        .add("converged", r.report.converged ? 1 : 0)
        .add("verified", r.report ? 1 : 0)
        .add("fault", to_string(r.report.fault()));
    if (r.positions.cols() == 0) {
      record.print();
      continue;
    }
    const CGP::Spin_result shifted = transformed(transformation, rho, 1);
    record.add("Q", r.report.conformality.quasi_conformal.mean)
        .add("flips", r.report.conformality.flipped_faces)
        .add("dirac_residual", r.report.dirac_residual)
        .add("branch_gap", r.report.branch_gap)
        .add("factorizations", r.report.factorizations)
        .add("move", distance(mesh, r.positions, last))
        .add("shifted", distance(mesh, r.positions, shifted.positions));
    record.print();
    last = r.positions;
  }
}

/// \brief the 12 eigenvalues next to a shift: how far the farthest is from a value of a list, and
/// how many of each there are within the window that is reported as complete, without a margin
void spectrum(const std::string& name, const CGP::Mesh_view& mesh, const std::vector<double>& exact,
              double shift)
{
  CGP::internal::Dirac_spectrum_options options;
  options.shift = shift;
  CGP::internal::Dirac_spectral_problem problem(mesh);
  const auto s = problem.find(CGP::no_potential(mesh), 12, options);
  const double margin = 0.1;  // more than the error of the mesh
  const auto is_inside = [&](double g) { return std::abs(g - shift) < s.complete_radius - margin; };
  double error = 0;
  int found = 0;
  for (const double g : s.eigenvalues) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const double e : exact) nearest = std::min(nearest, std::abs(e - g));
    error = std::max(error, nearest);
    found += is_inside(g);
  }
  Record record;
  record.add("spectrum", name)
      .add("shift", shift)
      .add("complete", s.is_complete() ? 1 : 0)
      .add("complete_radius", s.complete_radius)
      .add("error", error)
      .add("found", found)
      .add("exact", static_cast<int>(std::count_if(exact.begin(), exact.end(), is_inside)));
  record.print();
}

/// the integers n but -1, |n + 1| times each
std::vector<double> unit_sphere_spectrum()
{
  std::vector<double> values;
  for (int n = -12; n <= 12; ++n) values.insert(values.end(), std::abs(n + 1), n);
  return values;
}

}  // namespace

int main(int argc, char** argv)
{
  for (int k = 1; k < argc; ++k) try {
      sweep(argv[k]);
    } catch (const std::exception& e) {
      std::fprintf(stderr, "%s: left out: %s\n", argv[k], e.what());
    }
  const CGP::Mesh_view sphere = cgp_test::fibonacci_sphere(3000);
  const CGP::Mesh_view torus = cgp_test::torus(2, 1, 64, 32);
  for (int k = -4; k <= 4; ++k) spectrum("sphere", sphere, unit_sphere_spectrum(), k);
  for (int k = -2; k <= 2; ++k) spectrum("torus", torus, cgp_test::torus_spectrum(2, 1, 6), k);
}
