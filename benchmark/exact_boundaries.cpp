// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

/// Maps plane disks and rings to minimal surfaces of random Weierstrass data by the tangents,
/// binormals or positions of the boundary of these surfaces, on irregular meshes at three
/// resolutions. Prints a line of JSON for each.
///
/// Usage: benchmark_exact_boundaries [DOMAINS [FIRST]]   (60, 0; others are random anew)
///
/// A half of the domains are disks. Of the rings, a third have polynomial data, a third Laurent
/// ones, with a pole in the hole, and a third are turned inside out. What a user has is measured:
/// the boundary of a mesh.
#include <Conformal_geometry_processing/measure/alignment.h>
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <cmath>
#include <complex>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "support/Record.h"
#include "support/mesh_tools.h"
#include "support/random_delaunay.h"
#include "support/weierstrass.h"

namespace {

namespace CGP = Conformal_geometry_processing;
using CGP::Boundary_condition;
using Map = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

struct Domain {
  std::string name;
  std::vector<cgp_test::Circle> holes;
  Map map;
};

Domain domain(int k)
{
  const auto X = cgp_test::Weierstrass_surface::random(1000 + static_cast<std::uint64_t>(k));
  if (k % 2 == 0) return {"disk", {}, X};
  const std::complex<double> center(.1, .05);
  const double radius = .25 + .005 * (k % 30);
  const std::vector<cgp_test::Circle> hole{{{center.real(), center.imag()}, radius}};
  const auto laurent = [=](std::complex<double> constant, double linear) -> Map {
    return [=](const Eigen::Vector3d& p) {
      const std::complex<double> z(p.x(), p.y()), w = linear * z + constant / (z - center);
      return X({w.real(), w.imag(), 0});
    };
  };
  if (k % 6 == 1) return {"ring", hole, X};
  if (k % 6 == 3)
    return {"ring, Laurent", hole, laurent(std::polar(.4 * radius * radius, 1. * k), 1)};
  return {"ring, inside out", hole, laurent(.8 * radius, 0)};
}

/// one axis of each frame of the boundary
CGP::Points axes(const CGP::internal::Boundary_frames& boundary, Eigen::Index axis)
{
  CGP::Points all(3, static_cast<Eigen::Index>(boundary.vertices.size()));
  for (Eigen::Index k = 0; k < all.cols(); ++k)
    all.col(k) = boundary.frames[static_cast<std::size_t>(k)].col(axis);
  return all;
}

Boundary_condition condition(const std::string& name, const CGP::Mesh_view& target)
{
  const auto boundary = CGP::boundary_frames(target);
  if (name == "tangents") return Boundary_condition::tangents(axes(boundary, 0));
  if (name == "binormals") return Boundary_condition::binormals(axes(boundary, 2));
  return Boundary_condition::positions(target.positions()(Eigen::indexing::all, boundary.vertices),
                                       axes(boundary, 1));
}

void measure(int k, double h, const std::string& name)
{
  const Domain d = domain(k);
  const CGP::Mesh_view plane = cgp_test::random_domain(h, static_cast<std::uint64_t>(k), d.holes);
  const CGP::Mesh_view target = cgp_test::mapped(plane, d.map);
  const CGP::Spin_result r = CGP::Spin_transformation(plane, {condition(name, target)})
                                 .transform(CGP::Curvature_potential::on_vertices(
                                     Eigen::VectorXd::Zero(plane.size_of_vertices())));
  const bool has_surface = r.positions.cols() > 0;
  cgp_benchmark::Record()
      .add("case", k)
      .add("domain", d.name)
      .add("boundary", name)
      .add("h", h)
      .add("faces", plane.size_of_faces())
      .add("verified", r.report ? 1 : 0)
      .add("fault", std::string(CGP::to_string(r.report.fault())))
      .add("error", has_surface ? CGP::align(r.positions, target.positions()).rms : NAN)
      .add("q_mean", r.report.conformality.quasi_conformal.mean)
      .add("gamma_radius", std::abs(r.report.gamma_radius()))
      .add("missed", r.report.direction_error.mean)
      .print();
}

}  // namespace

int main(int argc, char** argv)
{
  const int domains = argc > 1 ? std::atoi(argv[1]) : 60, first = argc > 2 ? std::atoi(argv[2]) : 0;
  for (int k = first; k < first + domains; ++k)
    for (const std::string name : {"tangents", "binormals", "positions"})
      for (const double h : {.2, .1, .05}) measure(k, h, name);
}
