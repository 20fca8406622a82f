// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Smooths a closed curve in the plane without stretching it, and draws it on its way.
//
//   unwind_a_curve [INPUT.txt [OUTPUT.svg]]
//
// The input has a point per line, x and y, of size about 1. The curve becomes as little bent as its
// turning number allows: a circle, run through once or more, or a figure eight [CGP 6.4.3].
#include <Conformal_geometry_processing/isometric_curve_flow.h>

#include <CGAL/Simple_cartesian.h>

#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <vector>

namespace CGP = Conformal_geometry_processing;
using Point = CGAL::Simple_cartesian<double>::Point_2;

/// draws the curve of every tenth step beside the one before
struct Artist : CGP::Curve_flow_visitor {
  void draw(const Eigen::Matrix2Xd& points)
  {
    picture << "<polygon transform=\"translate(" << offset << ")\" points=\"";
    for (const auto& p : points.colwise()) picture << p.x() << ',' << -p.y() << ' ';
    picture << "\"/>\n";
    offset += 4.4;
  }
  void on_flow_begin(const Eigen::Matrix2Xd& points, double) { draw(points); }
  void on_step_end(const CGP::Curve_step_report& report, const Eigen::Matrix2Xd& points)
  {
    if (report.step % 10 == 0) draw(points);
  }
  std::ofstream picture;
  double offset = 0;
};

int main(int argc, char* argv[])
{
  std::ifstream input(argc > 1 ? argv[1] : "curve.txt");
  std::vector<Point> points;
  for (double x, y; input >> x >> y;) points.emplace_back(x, y);
  Artist artist;
  artist.picture.open(argc > 2 ? argv[2] : "unwind_a_curve.svg");
  artist.picture << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-2.2 -3.1 22 6\">\n"
                    "<g fill=\"none\" stroke=\"#1f4e79\" stroke-width=\".04\">\n";
  try {
    //! [curve]
    const CGP::Curve_flow_report report = CGP::isometric_curve_flow(
        points, CGP::parameters::time_step(.05).number_of_iterations(40).visitor(std::ref(artist)));
    std::cout << "turns " << report.turning_number << ", energy " << report.initial_energy << " to "
              << report.energy << ", lengths changed by " << report.length_distortion << '\n';
    //! [curve]
  } catch (const CGP::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return artist.picture << "</g>\n</svg>\n" ? EXIT_SUCCESS : EXIT_FAILURE;
}
