// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_CALCULUS_NORMALS_AND_CURVATURES_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_CALCULUS_NORMALS_AND_CURVATURES_H

#include <Conformal_geometry_processing/operators/calculus/Surface_derivative.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief N = -1/2 D f, 3 x |F|: exactly the face normals.
inline Points dirac_normals(const Surface_derivative& d)
{
  return -components(d(d.mesh().positions())).bottomRows<3>() / 2;
}

/// \ingroup PkgOperators
/// \brief the mean curvature H = 1/2 N D N = -1/2 <N, D N> on the faces, |F|; +1 on the unit
/// sphere.
///
/// First order, and damps high frequencies as D does. At vertices, and for flows, take
/// `mean_curvature()`.
/// \param normals of the surface at its vertices, 3 x |V|
inline Eigen::VectorXd dirac_mean_curvature(const Surface_derivative& d, const Points& normals)
{
  return -d.normal_part(d(normals)) / 2;
}

/// \ingroup PkgOperators
/// \brief the Gauss curvature K = 1/2 <N, Im(D^2) N> at the vertices, |V|, by the imaginary part of
/// D^H M_F D, which sums to zero in each row and holds the jumps of the face normals only.
///
/// The integral of K is exactly that of the matrix: second order on regular meshes.
/// \param normals of the surface at its vertices, 3 x |V|
/// \pre the surface is closed
inline Eigen::VectorXd dirac_gauss_curvature(const Surface_derivative& d, const Points& normals)
{
  const auto X = dirac_energy(d.mesh(), no_potential(d.mesh()));
  const Eigen::VectorXd areas = vertex_areas(d.mesh());
  Quaternion_vector<double> image(areas.size());
  X.for_each_entry([&](int i, int j, Quaternion<double> x) {
    x.w = 0;
    image[i] += x * imaginary(normals.col(j));
    if (i != j) image[j] += conjugate(x) * imaginary(normals.col(i));
  });
  Eigen::VectorXd K(areas.size());
  for (Eigen::Index v = 0; v < K.size(); ++v)
    K[v] = normals.col(v).dot(imaginary_part(image[v])) / (2 * areas[v]);
  return K;
}

}  // namespace Conformal_geometry_processing

#endif
