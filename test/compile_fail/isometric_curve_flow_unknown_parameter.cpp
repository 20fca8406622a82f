// expect: isometric_curve_flow\(\): unknown named parameter
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/isometric_curve_flow.h>

#include <CGAL/Simple_cartesian.h>

#include <vector>

namespace CGP = Conformal_geometry_processing;

int main()
{
  std::vector<CGAL::Simple_cartesian<double>::Point_2> points;
  (void)CGP::isometric_curve_flow(points, CGP::parameters::spectral_shift(.1));
}
