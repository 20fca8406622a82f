// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Quaternionic_linear_algebra/direct/Grounded_solver.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstddef>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgForms
/// the integral of a 1-form along halfedge h
/// \param omega |E| numbers, along each edge i -> j, i < j
template <class Derived>
double along_halfedge(const Mesh_view& mesh, const Eigen::MatrixBase<Derived>& omega, int h)
{
  return mesh.from(h) < mesh.to(h) ? omega[mesh.edge(h)] : -omega[mesh.edge(h)];
}

namespace internal {

/// \brief the integrals of a closed 1-form along the edges of a sheet.
///
/// An edge that joins a vertex with itself has no direction i -> j; its integral follows from the
/// other two, because the sum is zero.
template <class Derived>
Eigen::Vector3d along_edges(const Sheet& sheet, const Eigen::MatrixBase<Derived>& omega)
{
  Eigen::Vector3d values = Eigen::Vector3d::Zero();
  int loop = -1, loops = 0;
  for (int c = 0; c < 3; ++c) {
    const int from = sheet.corners[static_cast<std::size_t>((c + 1) % 3)],
              to = sheet.corners[static_cast<std::size_t>((c + 2) % 3)];
    if (from == to)
      loop = c, ++loops;
    else
      values[c] = (from < to ? 1 : -1) * omega[sheet.edges[static_cast<std::size_t>(c)]];
  }
  if (loops == 1) values[loop] = -values.sum();
  return values;
}

/// \brief Subtracts d0 u with L u = d0^T w omega from 1-forms omega; the result is co-closed.
/// \param laplacian solves with L of the surface
/// \returns u, |V| x their number
Eigen::MatrixXd remove_exact_parts(const Surface_ref& surface, const Eigen::VectorXd& w,
                                   const Grounded_solver& laplacian, Eigen::MatrixXd& forms);

/// Replaces closed forms by orthonormal ones with the same span. Uses their fields, whose inner
/// products are positive definite despite rounding, unlike sums with negative cotan weights.
/// \returns T, such that the new forms are the old ones times T
/// \throw Precondition_error if they are linearly dependent, or a number is not finite
Eigen::MatrixXd orthonormalize_forms(const Surface_ref& surface, Eigen::MatrixXd& forms);

}  // namespace internal

/// \ingroup PkgForms
/// \brief the tangent vector v of each sheet with <v, e> = omega(e) along its edges, 3 x sheets,
/// which are the faces of a mesh [CGP 6.4.5]; in units of omega per length.
///
/// v = (omega_1 e_2 - omega_2 e_1) x N / (2A). The sum of A <v, v'> over the faces equals the sum
/// of w_e omega_e omega'_e over the edges.
/// \param omega |E| numbers, a closed 1-form: otherwise v fits only two edges of a face
/// \pre no triangle has area zero
template <class Derived>
Points tangent_field(const Surface_ref& surface, const Eigen::MatrixBase<Derived>& omega)
{
  Points v(3, surface.size_of_sheets());
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    const Eigen::Vector3d values = internal::along_edges(sheet, omega), e = sheet.vectors.col(0),
                          normal = e.cross(sheet.vectors.col(1)),
                          turned =
                              values[1] * sheet.vectors.col(2) - values[2] * sheet.vectors.col(1);
    v.col(s) = turned.cross(normal) / normal.squaredNorm();
  }
  return v;
}

/// \ingroup PkgForms
/// \brief the harmonic 1-forms of a surface: 2G for genus G, or 2G + loops - 1 with a boundary;
/// orthonormal with respect to sum_e w_e omega_e omega'_e.
///
/// They are closed, d1 omega = 0, and co-closed, d0^T w omega = 0; at a boundary, their fields are
/// therefore tangent to it. The choice of the basis depends on the numbering of the mesh.
struct Harmonic_basis {
  Eigen::MatrixXd one_forms;   ///< |E| x `size()`, along each edge i -> j, i < j; dimensionless
  std::vector<Points> fields;  ///< each 3 x sheets: `tangent_field()` of the forms, in 1/length

  int size() const { return static_cast<int>(one_forms.cols()); }
  int genus() const { return size() / 2; }  ///< of closed surfaces
};

}  // namespace Conformal_geometry_processing
