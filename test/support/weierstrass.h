// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/random.h"

/// Minimal surfaces of polynomial Weierstrass data: exact conformal images of plane domains.
namespace cgp_test {

/// coefficients, the constant one first
using Polynomial = std::vector<std::complex<double>>;

Polynomial product(const Polynomial& a, const Polynomial& b);

std::complex<double> value(const Polynomial& a, std::complex<double> z);

Polynomial integral(const Polynomial& a);

/// X = Re of the integral of (f (1 - g^2)/2, i f (1 + g^2)/2, f g)
class Weierstrass_surface {
 public:
  Weierstrass_surface(const Polynomial& f, const Polynomial& g)
  {
    Polynomial minus = product(g, g), plus = minus;
    for (auto& c : minus) c = -c;
    minus[0] += 1.;
    plus[0] += 1.;
    m_form = {product({.5}, product(f, minus)), product({{0, .5}}, product(f, plus)),
              product(f, g)};
  }

  /// without branch points in the unit disk, where |f - 1| < 1
  static Weierstrass_surface random(std::uint64_t seed)
  {
    Random random(seed);
    const auto number = [&random](double size) -> std::complex<double> {
      const double x = random.number(), y = random.number();
      return size * std::complex<double>(x, y);
    };
    const Polynomial f{1, number(.4), number(.2)};
    return {f, {number(.5), number(.6), number(.3)}};
  }

  Eigen::Vector3d operator()(const Eigen::Vector3d& p) const
  {
    Eigen::Vector3d x;
    for (int i = 0; i < 3; ++i) x[i] = value(integral(m_form[at(i)]), {p.x(), p.y()}).real();
    return x;
  }

  /// dX(v) at the point p of the plane
  Eigen::Vector3d differential(const Eigen::Vector3d& p, const Eigen::Vector3d& v) const
  {
    Eigen::Vector3d x;
    for (int i = 0; i < 3; ++i)
      x[i] = (value(m_form[at(i)], {p.x(), p.y()}) * std::complex<double>(v.x(), v.y())).real();
    return x;
  }

 private:
  std::array<Polynomial, 3> m_form;
};

}  // namespace cgp_test
