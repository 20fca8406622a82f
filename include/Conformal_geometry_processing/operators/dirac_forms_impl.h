// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DIRAC_FORMS_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DIRAC_FORMS_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/operators/dirac_forms.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>

namespace Conformal_geometry_processing {

CGP_INLINE Dirac_forms dirac_forms(const Mesh_view& mesh, const Curvature_potential& rho,
                                   const Block<Quaternion<double>>& vectors)
{
  const Eigen::Index k = vectors.cols();
  Dirac_forms forms{Block<Quaternion<double>>(k, k), Block<Quaternion<double>>(k, k)};
  Block<Quaternion<double>> half(k, k);
  Quaternion_vector<double> average(k), image(k);  // of B, and of M_F (D - R), on one face
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const double A = mesh.double_area_vector(f).norm() / 2;
    const Eigen::Vector3d r = rho.at_corners(mesh, f);
    for (Eigen::Index a = 0; a < k; ++a) {
      average[a] = image[a] = {};
      for (int c = 0; c < 3; ++c) {
        const auto& l = vectors(mesh.corners(f)[static_cast<std::size_t>(c)], a);
        average[a] += l / 3.;
        image[a] -= imaginary(mesh.vector(3 * f + c)) * l / 2. + (A * r[c] / 3) * l;
      }
    }
    for (Eigen::Index a = 0; a < k; ++a)
      for (Eigen::Index b = 0; b < k; ++b) {
        half(a, b) += conjugate(average[a]) * image[b] / 2.;
        forms.mass(a, b) += A * (conjugate(average[a]) * average[b]);
      }
  }
  for (Eigen::Index a = 0; a < k; ++a)
    for (Eigen::Index b = 0; b < k; ++b) forms.dirac(a, b) = half(a, b) + conjugate(half(b, a));
  return forms;
}

CGP_INLINE Quaternion_vector<double> apply_dirac_form(const Mesh_view& mesh,
                                                      const Curvature_potential& rho,
                                                      const Quaternion_vector<double>& lambda)
{
  Quaternion_vector<double> result = Quaternion_vector<double>::Constant(lambda.size(), {});
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const double A = mesh.double_area_vector(f).norm() / 2;
    const Eigen::Vector3d r = rho.at_corners(mesh, f);
    Quaternion<double> average, image;      // as above
    std::array<Quaternion<double>, 3> row;  // of M_F (D - R)
    for (std::size_t c = 0; c < 3; ++c) {
      const int corner = static_cast<int>(c);
      row[c] = imaginary(mesh.vector(3 * f + corner)) / -2.;
      row[c].w -= A * r[corner] / 3;
      average += lambda[mesh.corners(f)[c]] / 3.;
      image += row[c] * lambda[mesh.corners(f)[c]];
    }
    for (std::size_t c = 0; c < 3; ++c)
      result[mesh.corners(f)[c]] += image / 6. + conjugate(row[c]) * average / 2.;
  }
  return result;
}

CGP_INLINE double dirac_quotient(const Mesh_view& mesh, const Curvature_potential& rho,
                                 const Quaternion_vector<double>& lambda)
{
  const Dirac_forms forms = dirac_forms(mesh, rho, lambda);
  return forms.dirac(0, 0).w / forms.mass(0, 0).w;
}

CGP_INLINE double dirac_misfit(const Mesh_view& mesh, const Curvature_potential& rho,
                               const Quaternion_vector<double>& lambda)
{
  double energy = 0, mass = 0;
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const double A = mesh.double_area_vector(f).norm() / 2;
    const Eigen::Vector3d r = rho.at_corners(mesh, f);
    Quaternion<double> image;  // of M_F (D - R)
    for (int c = 0; c < 3; ++c) {
      const auto& l = lambda[mesh.corners(f)[static_cast<std::size_t>(c)]];
      image -= imaginary(mesh.vector(3 * f + c)) * l / 2. + (A * r[c] / 3) * l;
      mass += A / 3 * squared_norm(l);
    }
    energy += squared_norm(image) / A;
  }
  return std::sqrt(energy / mass);
}

}  // namespace Conformal_geometry_processing

#endif
