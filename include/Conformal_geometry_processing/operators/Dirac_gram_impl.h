// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DIRAC_GRAM_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_OPERATORS_DIRAC_GRAM_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/operators/Dirac_gram.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace Conformal_geometry_processing {
namespace internal {

/// row r of the images: those on a sheet, times the root of its area and share
CGP_INLINE void add_images(const Sheet& sheet, const Eigen::Vector3d& rho,
                           const Block<Quaternion<double>>& vectors, Eigen::Index r,
                           Block<Quaternion<double>>& images)
{
  const Eigen::Index k = vectors.cols();
  const double root = std::sqrt(sheet.share / sheet.area);
  for (int c = 0; c < 3; ++c) {
    const Quaternion<double> edge = imaginary(Eigen::Vector3d(root / -2 * sheet.vectors.col(c)));
    const double third = root * sheet.area / 3;
    const int v = sheet.corners[static_cast<std::size_t>(c)];
    for (Eigen::Index a = 0; a < k; ++a) {
      images(r, a) += edge * vectors(v, a);
      images(r, k + a) += (third * rho[c]) * vectors(v, a);
      images(r, 2 * k + a) += third * vectors(v, a);
    }
  }
}

CGP_INLINE Dirac_gram::Dirac_gram(const Surface_ref& surface, const Curvature_potential& rho,
                                  const Block<Quaternion<double>>& vectors)
    : m_products(Block<Quaternion<double>>::Constant(3 * vectors.cols(), 3 * vectors.cols(), {}))
{
  const int all = surface.size_of_sheets(), most = 256;  // images of so many sheets fit the cache
  for (int first = 0; first < all; first += most) {
    const int count = (std::min)(most, all - first);
    Block<Quaternion<double>> images =
        Block<Quaternion<double>>::Constant(count, m_products.cols(), {});
    for (int i = 0; i < count; ++i) {
      const Sheet sheet = surface.sheet(first + i);
      add_images(sheet, rho.at_corners(sheet), vectors, i, images);
    }
    add(images);
  }
  for (Eigen::Index j = 0; j < m_products.cols(); ++j)
    for (Eigen::Index i = j + 1; i < m_products.rows(); ++i)
      m_products(i, j) = conjugate(m_products(j, i));
}

CGP_INLINE void Dirac_gram::add(const Block<Quaternion<double>>& images)
{
  for (Eigen::Index j = 0; j < images.cols(); ++j)
    for (Eigen::Index i = 0; i <= j; ++i)
      m_products(i, j) += inner_product(images.col(i), images.col(j));
}

CGP_INLINE Block<Quaternion<double>> Dirac_gram::energy(double t, double sigma) const
{
  const Eigen::Index k = size_of_vectors();
  const std::array<double, 3> factor{1, -t, -sigma};
  Block<Quaternion<double>> E = Block<Quaternion<double>>::Constant(k, k, {});
  for (Eigen::Index a = 0; a < 3; ++a)
    for (Eigen::Index b = 0; b < 3; ++b) {
      const double f = factor[static_cast<std::size_t>(a)] * factor[static_cast<std::size_t>(b)];
      for (Eigen::Index j = 0; j < k; ++j)
        for (Eigen::Index i = 0; i < k; ++i) E(i, j) += f * m_products(a * k + i, b * k + j);
    }
  return E;
}

CGP_INLINE Quaternion<double> Dirac_gram::form(Image a, Image b,
                                               const Quaternion_vector<double>& c) const
{
  const Eigen::Index k = size_of_vectors();
  Quaternion<double> sum;
  for (Eigen::Index j = 0; j < k; ++j)
    for (Eigen::Index i = 0; i < k; ++i)
      sum += conjugate(c[i]) * m_products(a * k + i, b * k + j) * c[j];
  return sum;
}

CGP_INLINE double Dirac_gram::quotient(double t, const Quaternion_vector<double>& c) const
{
  return (form(average, dirac, c).w - t * form(average, potential, c).w) /
         form(average, average, c).w;
}

}  // namespace internal
}  // namespace Conformal_geometry_processing

#endif
