// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DIRAC_FORMS_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DIRAC_FORMS_H

#include <Conformal_geometry_processing/algebra/Quaternion_vector.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>

namespace Conformal_geometry_processing {

/// \ingroup PkgOperators
/// \brief the two forms whose quotient is the eigenvalue of D - rho *with its sign*, on k vectors
/// V: |V| x k. Both k x k, Hermitian.
struct Dirac_forms {
  Block<Quaternion<double>> dirac;  ///< the Hermitian part of V^H B^H M_F (D - R) V; indefinite
  Block<Quaternion<double>> mass;   ///< V^H B^H M_F B V; positive definite
};

/// \ingroup PkgOperators
/// the forms on the columns of `vectors`; O(|F|), without assembling a matrix
inline Dirac_forms dirac_forms(const Mesh_view& mesh, const Curvature_potential& rho,
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

/// \ingroup PkgOperators
/// \brief H lambda, |V|, where H is the Hermitian part of B^H M_F (D - R): the form `dirac` of
/// \ref Dirac_forms as an operator. O(|F|), without assembling a matrix.
inline Quaternion_vector<double> apply_dirac_form(const Mesh_view& mesh,
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

/// \ingroup PkgOperators
/// \brief gamma = Re <B lambda, M_F (D - R) lambda> / <B lambda, M_F B lambda> for an eigenvector
/// lambda of X; in 1/length.
///
/// The eigenvalue mu of X is gamma^2 plus the discretisation error (unlike [CGP (5.3)], which
/// writes gamma for it): its root has no sign, and near zero not the right size either.
inline double dirac_quotient(const Mesh_view& mesh, const Curvature_potential& rho,
                             const Quaternion_vector<double>& lambda)
{
  const Dirac_forms forms = dirac_forms(mesh, rho, lambda);
  return forms.dirac(0, 0).w / forms.mass(0, 0).w;
}

/// \ingroup PkgOperators
/// \brief |(D - R) lambda| / |lambda|, in 1/length: the root of the quotient of X and the areas of
/// the vertices, to all digits also where it is zero but for rounding, for no terms cancel.
/// O(|F|), without assembling a matrix.
inline double dirac_misfit(const Mesh_view& mesh, const Curvature_potential& rho,
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
