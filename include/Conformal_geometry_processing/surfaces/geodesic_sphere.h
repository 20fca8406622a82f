// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <Eigen/Core>

#include <array>
#include <map>
#include <vector>

namespace Conformal_geometry_processing {

namespace internal {

/// Vertices (+-1, +-phi, 0) and cyclic permutations, faces counter-clockwise seen from outside
Mesh_view icosahedron();

/// Numbers the points of evenly subdivided faces; points on edges are shared.
class Geodesic_points {
 public:
  /// \param frequency the number of parts of an edge
  explicit Geodesic_points(int frequency) : m_frequency(frequency), m_base(icosahedron()) {}

  const Mesh_view& base() const { return m_base; }
  Points points() const;

  /// The point with these barycentric coordinates, times the frequency, in face f
  int number(int f, const std::array<int, 3>& weights);

 private:
  int m_frequency;
  Mesh_view m_base;
  std::vector<Eigen::Vector3d> m_points;
  std::map<std::map<int, int>, int> m_numbers;
};

}  // namespace internal

/// \ingroup PkgSurfaces
/// \brief Creates the unit sphere with 20 n^2 faces: divides the edges of the icosahedron into n
/// parts and projects the points of its faces. Normals point outward.
/// \param frequency n
/// \throw Precondition_error if it is below one
Mesh_view geodesic_sphere(int frequency);

}  // namespace Conformal_geometry_processing
