// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Quaternionic_linear_algebra/exceptions.h>

#include <Eigen/Core>

#include <array>
#include <string>
#include <utility>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief rho: the change of mean curvature by a spin transformation, in 1/length, with one value
/// per vertex or one per face.
///
/// H~ |lambda|^2 = H + rho + gamma: positive rho bulges outward [CGP (4.6)].
struct Curvature_potential {
  enum class On { vertices, faces };

  On on;
  Eigen::VectorXd values;  ///< |V| or |F|

  static Curvature_potential on_vertices(Eigen::VectorXd rho);
  static Curvature_potential on_faces(Eigen::VectorXd rho) { return {On::faces, std::move(rho)}; }

  /// its values at the three corners of a sheet
  Eigen::Vector3d at_corners(const Sheet& sheet) const
  {
    if (on == On::faces) return Eigen::Vector3d::Constant(values[sheet.face]);
    const std::array<int, 3>& v = sheet.corners;
    return {values[v[0]], values[v[1]], values[v[2]]};
  }
};

/// \ingroup PkgOperators
/// rho = 0, on the vertices
Curvature_potential no_potential(const Surface_ref& surface);

/// \ingroup PkgOperators
/// \brief the areas that belong to the values of rho, |V| or |F|: integrals over the surface are
/// sums weighted by them. The area of a face is at least a millionth of the mean, so that division
/// by it is safe.
Eigen::VectorXd curvature_areas(const Surface_ref& surface, Curvature_potential::On on);

/// \ingroup PkgOperators
/// the mean of rho over the surface, weighted by area
double mean(const Surface_ref& surface, const Curvature_potential& rho);

/// \ingroup PkgOperators
/// \throw Precondition_error if rho has the wrong length or a value that is not finite, also after
/// conversion to 1/`unit`
void require_potential(const Mesh_view& mesh, const Curvature_potential& rho, double unit,
                       const std::string& function);

}  // namespace Conformal_geometry_processing
