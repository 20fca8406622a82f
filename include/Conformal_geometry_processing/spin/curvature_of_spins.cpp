// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/curvature_of_spins.h>

#include <Eigen/Core>

#include <cstddef>

namespace Conformal_geometry_processing {

Curvature_potential curvature_of_spins(const Surface_ref& surface,
                                       const Quaternion_vector<double>& mu)
{
  Eigen::VectorXd products = Eigen::VectorXd::Zero(surface.size_of_faces()), squares = products,
                  areas = products;
  for (int s = 0; s < surface.size_of_sheets(); ++s) {
    const Sheet sheet = surface.sheet(s);
    Quaternion<double> average, image;  // B mu, and M D mu
    for (int c = 0; c < 3; ++c) {
      const auto& l = mu[sheet.corners[static_cast<std::size_t>(c)]];
      const Eigen::Vector3d e = sheet.vectors.col(c) / 2;
      average += l / 3.;
      image -= imaginary(e) * l;
    }
    products[sheet.face] += sheet.share * dot(average, image);
    areas[sheet.face] += sheet.share * sheet.area;
    squares[sheet.face] += sheet.share * sheet.area * squared_norm(average);
  }
  return Curvature_potential::on_faces((squares.array() > 0 && areas.array() > 1e-6 * areas.mean())
                                           .select(products.cwiseQuotient(squares), 0));
}

}  // namespace Conformal_geometry_processing
