// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Distributed_mesh.h"

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace conformal::mpi {

/// all faces of a part, as a surface whose boundary is that of the whole
struct Faces_of_part {
  const Distributed_mesh& part;

  const CGP::Points& positions() const { return part.mesh().positions(); }
  const std::vector<std::array<int, 2>>& ends() const { return part.mesh().ends(); }
  int size_of_faces() const { return part.mesh().size_of_faces(); }
  int size_of_sheets() const { return size_of_faces(); }
  CGP::Sheet sheet(int f) const { return part.mesh().sheet(f); }
};

/// one loop without vertices where there is a boundary, wherever it is
inline std::vector<std::vector<int>> boundary_loops(const Faces_of_part& faces)
{
  return std::vector<std::vector<int>>(faces.part.is_closed() ? 0 : 1);
}

/// the faces that a process counts, as a surface: sums over them are sums over the whole
struct Counted_faces : Faces_of_part {
  int size_of_sheets() const { return part.own_faces(); }
};

/// \brief between 0 and 1, one for the same vector up to a right factor. Collective.
/// \param areas of the vertices of the part
double overlap(const Distributed_mesh& mesh, const Eigen::VectorXd& areas,
               const CGP::Quaternion_vector<double>& a, const CGP::Quaternion_vector<double>& b);

}  // namespace conformal::mpi
