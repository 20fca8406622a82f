// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief finds the shift that is the quotient of its own eigenvector: the zero of the change from
/// a shift to that quotient, by the secant method.
///
/// The derivative of the change is nearly -1 on fine meshes, where the eigenvector hardly depends
/// on the shift, and nearer to zero the coarser the mesh.
class Shift_secant {
 public:
  /// forgets the last change, but not the derivative: for another vector near by
  void restart() { m_change = std::numeric_limits<double>::infinity(); }

  /// whether a change is smaller than the last one
  bool is_nearer(double change) const { return std::abs(change) < std::abs(m_change); }

  /// \brief the step from a shift to the zero.
  /// \param error of the change: those that differ by less say nothing about the derivative
  double step(double shift, double change, double error)
  {
    const double steepest = -2, flattest = -0.05;
    if (std::isfinite(m_change) && shift != m_shift && std::abs(change - m_change) > error)
      m_slope = std::clamp((change - m_change) / (shift - m_shift), steepest, flattest);
    m_shift = shift;
    m_change = change;
    return -change / m_slope;
  }

 private:
  double m_shift = 0, m_slope = -1;
  double m_change =
      std::numeric_limits<double>::infinity();  // at m_shift; infinite before the first
};

}  // namespace Conformal_geometry_processing::internal
