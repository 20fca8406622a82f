// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/spin/follow_branch.h>

#include <Quaternionic_linear_algebra/dense/hermitian_eigen_decomposition.h>
#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <array>
#include <cstddef>
#include <utility>

namespace Conformal_geometry_processing::internal {

/// the matrix of v -> e v for components (w, x, y, z) and imaginary e
Eigen::Matrix4d left_factor(const Eigen::Vector3d& e)
{
  Eigen::Matrix4d L;
  L << 0, -e[0], -e[1], -e[2],  //
      e[0], 0, -e[2], e[1],     //
      e[1], e[2], 0, -e[0],     //
      e[2], -e[1], e[0], 0;
  return L;
}

/// The images on a sheet, times the root of its area and share: four real numbers for each of
/// (D - base) v, R v and B v, for each vector v.
void add_images(const Sheet& sheet, const Eigen::Vector3d& base, const Eigen::Vector3d& rho,
                const Block<Quaternion<double>>& vectors, double* images)
{
  using Four = Eigen::Vector4d;
  const double root = std::sqrt(sheet.share / sheet.area), third = root * sheet.area / 3;
  std::array<Eigen::Matrix4d, 3> row;
  for (int c = 0; c < 3; ++c)
    row[static_cast<std::size_t>(c)] = left_factor(root / -2 * sheet.vectors.col(c)) -
                                       third * base[c] * Eigen::Matrix4d::Identity();
  for (Eigen::Index a = 0; a < vectors.cols(); ++a, images += 12) {
    Four dirac = Four::Zero(), potential = Four::Zero(), average = Four::Zero();
    for (int c = 0; c < 3; ++c) {
      const Eigen::Map<const Four> v(&vectors(sheet.corners[static_cast<std::size_t>(c)], a).w);
      dirac += row[static_cast<std::size_t>(c)] * v;
      potential += rho[c] * v;
      average += v;
    }
    Eigen::Map<Four>{images} = dirac;
    Eigen::Map<Four>{images + 4} = third * potential;
    Eigen::Map<Four>{images + 8} = third * average;
  }
}

/// conjugate(a) b, summed, from the sums of products of their components
Quaternion<double> inner_product_of(const Eigen::Matrix4d& s)
{
  return {s(0, 0) + s(1, 1) + s(2, 2) + s(3, 3), s(0, 1) - s(1, 0) - s(2, 3) + s(3, 2),
          s(0, 2) + s(1, 3) - s(2, 0) - s(3, 1), s(0, 3) - s(1, 2) + s(2, 1) - s(3, 0)};
}

// Real products, because Eigen's are several times as fast as sums of products of quaternions.
void Dirac_gram::extend(const Surface_ref& surface, const Curvature_potential& base,
                        const Curvature_potential& rho, const Block<Quaternion<double>>& vectors)
{
  const Eigen::Index old = m_products.cols(), all = images * vectors.cols(), added = all - old;
  if (added == 0) return;
  // The images of `most` rows fit the cache; there is a sum for every `at_once` of them.
  const std::ptrdiff_t most = 256, at_once = 2048;
  const auto add = [&](std::ptrdiff_t begin, std::ptrdiff_t end, Eigen::MatrixXd& sums) {
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> part(most, 4 * all);
    for (std::ptrdiff_t first = begin; first < end; first += most) {
      const std::ptrdiff_t count = (std::min)(most, end - first);
      for (std::ptrdiff_t i = 0; i < count; ++i) {
        const Sheet sheet = surface.sheet(static_cast<int>(first + i));
        add_images(sheet, base.at_corners(sheet), rho.at_corners(sheet), vectors, &part(i, 0));
      }
      sums.noalias() += part.topRows(count).transpose() * part.topRows(count).rightCols(4 * added);
    }
  };
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(4 * all, 4 * added);
  const Eigen::MatrixXd sums = sum_of_ranges(surface.size_of_sheets(), at_once, zero, add);
  m_products.conservativeResize(all, all);
  for (Eigen::Index j = old; j < all; ++j)
    for (Eigen::Index i = 0; i <= j; ++i) {
      m_products(i, j) = inner_product_of(sums.block<4, 4>(4 * i, 4 * (j - old)));
      m_products(j, i) = conjugate(m_products(i, j));
    }
}

void Dirac_gram::forget_all_but(Eigen::Index count)
{
  const Eigen::Index kept = images * count, late = m_products.cols() - kept;
  if (late <= images) return;
  Block<Quaternion<double>> products(images + kept, images + kept);
  products << m_products.topLeftCorner(images, images), m_products.topRightCorner(images, kept),
      m_products.bottomLeftCorner(kept, images), m_products.bottomRightCorner(kept, kept);
  m_products = std::move(products);
}

Dirac_gram Dirac_gram::without_last() const
{
  const Eigen::Index kept = m_products.cols() - images;
  Dirac_gram rest;
  rest.m_products = m_products.topLeftCorner(kept, kept);
  return rest;
}

Block<Quaternion<double>> Dirac_gram::energy(double t, double sigma) const
{
  const Eigen::Index k = size_of_vectors();
  const std::array<double, 3> factor{1, -t, -sigma};
  Block<Quaternion<double>> E = Block<Quaternion<double>>::Constant(k, k, {});
  for (Eigen::Index a = 0; a < images; ++a)
    for (Eigen::Index b = 0; b < images; ++b) {
      const double f = factor[static_cast<std::size_t>(a)] * factor[static_cast<std::size_t>(b)];
      for (Eigen::Index j = 0; j < k; ++j)
        for (Eigen::Index i = 0; i < k; ++i)
          E(i, j) += f * m_products(images * i + a, images * j + b);
    }
  return E;
}

Quaternion<double> Dirac_gram::form(Image a, Image b, const Quaternion_vector<double>& c) const
{
  const Eigen::Index k = size_of_vectors();
  Quaternion<double> sum;
  for (Eigen::Index j = 0; j < k; ++j)
    for (Eigen::Index i = 0; i < k; ++i)
      sum += conjugate(c[i]) * m_products(images * i + a, images * j + b) * c[j];
  return sum;
}

double Dirac_gram::quotient(double t, const Quaternion_vector<double>& c) const
{
  return (form(average, dirac, c).w - t * form(average, potential, c).w) /
         form(average, average, c).w;
}

double overlap_of(const Quaternion_vector<double>& a, const Quaternion_vector<double>& b)
{
  return norm(inner_product(a, b));
}

/// the point at t on the branch of `from`
Branch_point continued(const Dirac_gram& gram, const Branch_point& from, double t)
{
  Branch_point to = from;
  to.t = t;
  to.gamma += gram.quotient(t, from.c) - gram.quotient(from.t, from.c);
  for (int k = 0; k < 4; ++k) {
    const auto ritz = hermitian_eigen_decomposition(gram.energy(t, to.gamma));
    Eigen::Index own = 0;
    for (Eigen::Index j = 1; j < ritz.values.size(); ++j)
      if (overlap_of(ritz.vectors.col(j), from.c) > overlap_of(ritz.vectors.col(own), from.c))
        own = j;
    to.c = ritz.vectors.col(own);
    const double before = to.gamma;
    to.gamma = gram.quotient(t, to.c);
    to.misfit = std::sqrt((std::max)(ritz.values[own], 0.));
    if (ritz.values.size() == 1) return to;
    to.gap = std::sqrt((std::max)(ritz.values[own == 0 ? 1 : 0], 0.));
    if (std::abs(to.gamma - before) <= 1e-3 * to.gap) break;
  }
  to.least_gap = (std::min)(from.least_gap, to.gap);
  return to;
}

Branch_point follow_branch(const Dirac_gram& gram, const Branch_point& first, double end,
                           double least_overlap)
{
  const double longest = 1. / 4, shortest = 1. / 24, smooth = 0.95, same_branch = 0.75;
  Branch_point at = first;
  at.is_settled = false;
  double step = longest;
  while (at.t < end) {
    const Branch_point next = continued(gram, at, (std::min)(end, at.t + step));
    const double turn = overlap_of(next.c, at.c), all = overlap_of(next.c, first.c);
    if ((turn < smooth || all < least_overlap) && step > shortest) {
      step = (std::max)(step / 2, shortest);
      continue;
    }
    if (turn < same_branch || all < least_overlap) return at;
    at = next;
    step = (std::min)(2 * step, longest);
  }
  return at;
}

/// the point in the span without the last vector
Branch_point without_last(Branch_point p)
{
  p.c = p.c.head(p.c.size() - 1).eval();
  components(p.c) /= components(p.c).norm();
  return p;
}

Branch_point follow_settled_branch(const Dirac_gram& gram, const Branch_point& first, double end)
{
  const double step = 1. / 8, little = 0.97, same = 0.98;
  Branch_point at = first;
  at.is_settled = true;
  if (!(components(first.c).leftCols(first.c.size() - 1).norm() > 0)) return at;
  const Dirac_gram smaller_gram = gram.without_last();
  Branch_point in_smaller = without_last(first);
  while (at.t < end) {
    const double t = (std::min)(end, at.t + step);
    const Branch_point next = follow_branch(gram, at, t, little);
    in_smaller = follow_branch(smaller_gram, in_smaller, t, little);
    const auto shared = next.c.head(in_smaller.c.size());
    const bool has_settled =
        next.t == t && in_smaller.t == t && norm(inner_product(in_smaller.c, shared)) >= same;
    if (!has_settled || next.misfit > next.gap / 2) return at;
    at = next;
    at.is_settled = true;
  }
  return at;
}

}  // namespace Conformal_geometry_processing::internal
