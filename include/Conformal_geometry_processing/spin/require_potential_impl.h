// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SPIN_REQUIRE_POTENTIAL_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_SPIN_REQUIRE_POTENTIAL_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/spin/require_potential.h>

#include <cmath>
#include <string>

namespace Conformal_geometry_processing {

CGP_INLINE void require_potential(const Mesh_view& mesh, const Curvature_potential& rho,
                                  double unit, const std::string& function)
{
  const bool on_faces = rho.on == Curvature_potential::On::faces;
  const int size = on_faces ? mesh.size_of_faces() : mesh.size_of_vertices();
  const std::string element = on_faces ? "face" : "vertex";
  if (rho.values.size() != size)
    throw Precondition_error(function, "rho has " + std::to_string(rho.values.size()) +
                                           " values, one per " + element +
                                           " is needed: " + std::to_string(size));
  internal::refuse_if_any(
      size, [&](int i) { return !std::isfinite(rho.values[i] * unit); },
      [&](int i) { return element + " " + std::to_string(i); }, function,
      "#value of rho not finite", "finite values are needed");
}

}  // namespace Conformal_geometry_processing

#endif
