// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_SURFACES_JACOBI_FUNCTIONS_H
#define CONFORMAL_GEOMETRY_PROCESSING_SURFACES_JACOBI_FUNCTIONS_H

#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

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

}  // namespace internal
}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/surfaces/Jacobi_functions_impl.h>
#endif

#endif
