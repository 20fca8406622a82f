// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Finds the smoothest torus of a conformal class, from one that is far from smooth.
//
//   smoothest_torus [B [BEFORE.ply [AFTER.ply]]]    B from 1.06 to 3.7 [1.25]
//
// Conformally every torus is a parallelogram, here a rectangle of sides 1 and B; the conformal
// Willmore flow keeps it [CGP 6.5.4]. For 1 <= B <= sqrt(3) the flow ends at the round torus with
// B^2 = (R/r)^2 - 1, or one of its Moebius images: the energy is pi^2 (B + 1/B).
#include <Conformal_geometry_processing/flow/Conformal_willmore_flow.h>
#include <Conformal_geometry_processing/surfaces/tori.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace CGP = Conformal_geometry_processing;
using Point = CGAL::Simple_cartesian<double>::Point_3;
const double pi = std::acos(-1.);

/// a knobbly tube, its middle at the distance R from the axis
CGP::Mesh_view knobbly_torus(double R)
{
  return CGP::torus_grid(80, 40, 0, [R](int i, int j) {
    const double u = pi * i / 40, v = pi * j / 20;
    const double r = 1 + .15 * std::cos(5 * u) * std::cos(2 * v) + .075 * std::cos(5 * v);
    const double distance = R + r * std::cos(v);
    return Eigen::Vector3d(distance * std::cos(u), distance * std::sin(u), r * std::sin(v));
  });
}

void write(const char* path, const CGP::Mesh_view& mesh)
{
  std::vector<Point> points;
  for (const auto& p : mesh.positions().colwise()) points.emplace_back(p.x(), p.y(), p.z());
  if (!CGAL::IO::write_polygon_soup(path, points, mesh.corners()))
    throw CGP::Error("smoothest_torus", std::string("cannot write ") + path);
}

int main(int argc, char* argv[])
{
  const double b = argc > 1 ? std::atof(argv[1]) : 1.25;
  try {
    //! [torus]
    const CGP::Mesh_view torus = CGP::torus_of_class(knobbly_torus, b, 1.3, 4);
    CGP::Flow_options options;
    options.surface.exact_conformal_class = false;
    options.time_step = .15;  // the class changes in proportion to it
    options.balance = CGP::Flow_options::Balance::canonical;
    CGP::Conformal_willmore_flow flow(torus, options);
    const CGP::Flow_report report = flow.run();

    std::cout << "modulus " << CGP::conformal_modulus(torus) << " before, "
              << CGP::conformal_modulus(flow.mesh()) << " after " << report.steps.size()
              << " steps\nenergy  " << report.initial_energy << " before, " << report.energy
              << " after, smoothest " << pi * pi * (b + 1 / b) << '\n'
              << to_string(report.stop) << '\n';
    //! [torus]
    write(argc > 2 ? argv[2] : "torus.ply", torus);
    write(argc > 3 ? argv[3] : "smoothest_torus.ply", flow.mesh());
    return report ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const CGP::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
