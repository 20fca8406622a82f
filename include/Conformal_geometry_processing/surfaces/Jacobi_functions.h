// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSurfaces
/// \brief Jacobi's elliptic functions of one modulus, by arithmetic-geometric means.
///
/// The modulus is given by its complement k' = sqrt(1 - k^2), which keeps its digits where k tends
/// to one.
class Jacobi_functions {
 public:
  struct Values {
    double dn;
    double second_integral;  ///< E(am t), the integral of dn^2 from 0 to t
  };

  /// \param complement k', 0 < k' <= 1
  explicit Jacobi_functions(double complement = 1);

  /// K
  double quarter_period() const { return m_quarter_period; }

  /// \param t 0 <= t <= K
  Values operator()(double t) const;

 private:
  double m_complement, m_quarter_period;
  double m_ratio;                // E / K
  std::vector<double> m_a, m_c;  // of the steps of the mean
};

}  // namespace Conformal_geometry_processing::internal
