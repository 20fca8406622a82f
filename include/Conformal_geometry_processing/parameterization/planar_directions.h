// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_PLANAR_DIRECTIONS_H
#define CONFORMAL_GEOMETRY_PROCESSING_PARAMETERIZATION_PLANAR_DIRECTIONS_H

#include <Conformal_geometry_processing/exceptions.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/normals.h>
#include <Conformal_geometry_processing/mesh/requirements.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/parameterization/normalized_boundary.h>

#include <Eigen/Core>

#include <cmath>
#include <complex>
#include <string>

namespace Conformal_geometry_processing {

/// \ingroup PkgParameterization
/// \brief by which angle the boundary turns to the left in the surface, at each vertex of a loop:
/// pi minus the angle of the surface there.
inline Eigen::VectorXd turning_angles(const Mesh_view& mesh, const Vertex_loop& loop)
{
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(mesh.size_of_vertices());
  for (int f = 0; f < mesh.size_of_faces(); ++f)
    for (int c = 0; c < 3; ++c)
      angles[mesh.corners(f)[static_cast<std::size_t>(c)]] += corner_angle(mesh, f, c);
  return std::acos(-1.) - angles(loop).array();
}

/// \ingroup PkgParameterization
/// \brief tangents of a closed plane curve that a disk may get as its boundary, to be flattened by
/// rho = -H: what `minimal_surface()` makes of it then lies in the plane [CGP 6.5.3].
///
/// The curve turns as the boundary does in the surface. What is missing to 2 pi, by the theorem of
/// Gauss and Bonnet the total curvature of the surface, is spread evenly along it. So a flat disk
/// keeps its shape, and a hemisphere becomes a round disk. Any other directions in the plane that
/// turn once will do as well.
/// \code
/// const auto flat = spin_to_minimal_surface(mesh,
///                                           Boundary_condition::tangents(planar_directions(mesh)));
/// \endcode
///
/// \returns 3 x number of boundary vertices, unit vectors with z = 0, in the order of
/// `boundary_frames()`; as targets of `Boundary_condition::tangents()`
/// \throw Precondition_error if the mesh is not a disk
/// \pre `require_surface(mesh)` holds
inline Points planar_directions(const Mesh_view& mesh,
                                const std::string& function = "planar_directions")
{
  if (!topology(mesh).is_disk())
    throw Precondition_error(function,
                             "the surface is not a disk (one loop, no handles); a disk is needed");
  const Vertex_loop loop = boundary_loops(mesh).front();
  const Eigen::VectorXd turn = turning_angles(mesh, loop), length = lengths_along(mesh, loop);
  const Eigen::Index n = turn.size();
  const double missing = 2 * std::acos(-1.) - turn.sum();
  Points directions = Points::Zero(3, n);
  double angle = 0;  // of the edge that comes in, the first one lies along the x axis
  for (Eigen::Index k = 0; k < n; ++k) {
    const double in = k == 0 ? length[n] - length[n - 1] : length[k] - length[k - 1],
                 out = length[k + 1] - length[k],
                 next = angle + turn[k] + missing * (in + out) / (2 * length[n]);
    const std::complex<double> sum = std::polar(in, angle) + std::polar(out, next);
    directions.col(k) << sum.real() / std::abs(sum), sum.imag() / std::abs(sum), 0;
    angle = next;
  }
  return directions;
}

}  // namespace Conformal_geometry_processing

#endif
