// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

namespace Conformal_geometry_processing::internal {

/// \brief the time step of a flow with backtracking: shrinks after failures and grows again.
///
/// Growth by a smaller factor than halving undoes, and only after successes without it, prevents a
/// flow with a limited step from failing in every other trial: each time that growth fails, it
/// waits for twice as many of them.
class Time_step {
 public:
  /// \param first tried first
  /// \pre 0 < smallest <= first <= largest
  Time_step(double largest, double smallest, double first);

  double value() const { return m_value; }

  /// call after a failed step; returns false and keeps the step if half of it would be too small
  bool halve();

  /// call after a successful step
  void grow();

 private:
  double m_largest, m_smallest, m_value;
  int m_waiting = 0, m_next_waiting = 1;  // successes without growth
  bool m_has_grown = false;               // by the last success
};

}  // namespace Conformal_geometry_processing::internal
