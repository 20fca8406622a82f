// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DIRAC_ENERGY_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DIRAC_ENERGY_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>
#include <Conformal_geometry_processing/operators/vertex_graph.h>

#include <Eigen/Core>

namespace Conformal_geometry_processing {

CGP_INLINE void assemble_dirac_energy(const Surface_ref& surface, const Curvature_potential& rho,
                                      Hermitian_sparse_matrix<Quaternion<double>>& X)
{
  X.set_zero();
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    const Eigen::Vector3d r = rho.at_corners(sheet);
    Quaternion<double> e[3];
    for (int c = 0; c < 3; ++c) e[c] = imaginary(sheet.vectors.col(c).eval());
    const auto entry = [&](int i, int j) {
      Quaternion<double> x = (r[i] * e[j] - r[j] * e[i]) / 6. - e[i] * e[j] / (4 * sheet.area);
      x.w += sheet.area * r[i] * r[j] / 9;
      return x * sheet.share;
    };
    internal::add_sheet(sheet, entry, X);
  }
}

CGP_INLINE Hermitian_sparse_matrix<Quaternion<double>> dirac_energy(const Surface_ref& surface,
                                                                    const Curvature_potential& rho)
{
  Hermitian_sparse_matrix<Quaternion<double>> X(vertex_graph(surface));
  assemble_dirac_energy(surface, rho, X);
  return X;
}

CGP_INLINE Hermitian_sparse_matrix<Quaternion<double>> dirac_form(const Surface_ref& surface,
                                                                  const Curvature_potential& rho)
{
  Hermitian_sparse_matrix<Quaternion<double>> K(vertex_graph(surface));
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    const Eigen::Vector3d r = rho.at_corners(sheet);
    const auto entry = [&](int i, int j) {
      const Eigen::Vector3d e = (sheet.vectors.col(i) - sheet.vectors.col(j)) / 12;
      Quaternion<double> k = imaginary(e);
      k.w = -sheet.area * (r[i] + r[j]) / 18;
      return k * sheet.share;
    };
    internal::add_sheet(sheet, entry, K);
  }
  return K;
}

}  // namespace Conformal_geometry_processing

#endif
