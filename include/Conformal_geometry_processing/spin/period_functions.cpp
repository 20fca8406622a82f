// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/period_functions.h>

#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Conformal_geometry_processing/operators/dirac_energy.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace Conformal_geometry_processing::internal {

/// half of the gradient of the periods by lambda, one column for each form and axis
Block<Quaternion<double>> period_gradient(const Surface_ref& surface, const Harmonic_basis& basis,
                                          const Quaternion_vector<double>& lambda)
{
  const std::array<Quaternion<double>, 3> axes = {{{0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  const Eigen::VectorXd w = cotan_weights(surface);
  Block<Quaternion<double>> c =
      Block<Quaternion<double>>::Constant(surface.size_of_vertices(), 3 * basis.size(), {});
  for (int k = 0; k < surface.size_of_edges(); ++k) {
    const auto [i, j] = surface.ends(k);
    const Eigen::Vector3d e = surface.position(j) - surface.position(i);
    // A change m of l_i changes `transformed_edge()` by Im((2 conj(l_i) + conj(l_j)) e m) / 3.
    const Quaternion<double> at_i = imaginary(e) * (2. * lambda[i] + lambda[j]) / 6.,
                             at_j = imaginary(e) * (lambda[i] + 2. * lambda[j]) / 6.;
    for (int f = 0; f < basis.size(); ++f)
      for (int a = 0; a < 3; ++a) {
        const auto axis =
            w[k] * basis.one_forms(k, f) * conjugate(axes[static_cast<std::size_t>(a)]);
        c(i, 3 * f + a) += at_i * axis;
        c(j, 3 * f + a) += at_j * axis;
      }
  }
  return c;
}

/// z with <(D - R) y, R' lambda> = sum_i A_i rho'_i z_i for all changes rho' of rho
Eigen::VectorXd represented_change(const Surface_ref& surface, const Curvature_potential& rho,
                                   const Quaternion_vector<double>& lambda,
                                   const Quaternion_vector<double>& y)
{
  const Eigen::VectorXd areas = curvature_areas(surface, rho.on);
  Eigen::VectorXd z = Eigen::VectorXd::Zero(areas.size());
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    const Eigen::Vector3d r = rho.at_corners(sheet);
    Quaternion<double> image;
    for (int c = 0; c < 3; ++c)
      image += dirac_row(sheet, r, c) * y[sheet.corners[static_cast<std::size_t>(c)]];
    for (const int v : sheet.corners)
      z[rho.on == Curvature_potential::On::faces ? sheet.face : v] +=
          sheet.share / 3 * dot(image, lambda[v]);
  }
  return z.cwiseQuotient(areas);
}

Eigen::MatrixXd period_functions(const Surface_ref& surface, const Harmonic_basis& basis,
                                 const Curvature_potential& rho,
                                 const Quaternion_vector<double>& lambda,
                                 const Spin_response& respond)
{
  const Block<Quaternion<double>> Y = respond(period_gradient(surface, basis, lambda));
  Eigen::MatrixXd z(rho.values.size(), Y.cols());
  for (Eigen::Index i = 0; i < Y.cols(); ++i)
    z.col(i) = represented_change(surface, rho, lambda, Y.col(i));
  return z;
}

}  // namespace Conformal_geometry_processing::internal
