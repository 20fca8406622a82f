// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// A user's program over the component core.
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/version.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion.h>

#include <iostream>

namespace CGP = Conformal_geometry_processing;

int main()
{
#ifdef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
#error "core must not ask for CHOLMOD"
#endif
  const CGP::Mesh_view triangle(CGP::Points(CGP::Points::Identity(3, 3)), {{0, 1, 2}});
  const CGP::Quaternion<double> i{0, 1, 0, 0};
  const bool right = triangle.corners(0)[2] == 2 && (i * i).w == -1;
  std::cout << "core " << CONFORMAL_GEOMETRY_PROCESSING_VERSION << (right ? "" : " is wrong")
            << '\n';
  return right ? 0 : 1;
}
