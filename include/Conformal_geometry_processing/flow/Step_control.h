// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <optional>

namespace Conformal_geometry_processing::internal {

/// \brief the length of a step with backtracking: shrinks after failures and grows again.
///
/// Growth by a smaller factor than halving undoes, and only after successes without it, prevents a
/// flow with a limited step from failing in every other trial: each time that growth fails, it
/// waits for twice as many of them.
class Time_step {
 public:
  /// \param first tried first
  /// \param growth after a success
  /// \pre 0 < smallest <= first <= largest
  Time_step(double largest, double smallest, double first, double growth = 1.5);

  double value() const { return m_value; }

  /// call after a failed step; returns false and keeps the step if half of it would be too small
  bool halve();

  /// call after a successful step
  void grow();

 private:
  double m_largest, m_smallest, m_value, m_growth;
  int m_waiting = 0, m_next_waiting = 1;  // successes without growth
  bool m_has_grown = false;               // by the last success
};

/// \brief for how many steps a part of a step is left out that is not worth its time: for one, and
/// each time in a row that it was not, for twice as many.
class Pause {
 public:
  /// whether the next step goes without; it counts as made
  bool holds() { return m_left > 0 && m_left-- > 0; }

  void end() { m_left = 0; }

  /// call after a step with this part
  void learn(bool is_worthwhile)
  {
    m_left = is_worthwhile ? 0 : m_next;
    m_next = is_worthwhile ? 1 : 2 * m_next;
  }

 private:
  int m_left = 0, m_next = 1;  // steps
};

/// what a flow knows of its smoothing
struct Smoothing {
  Pause pause;
  bool has_settled = false;  ///< nothing is gained by it, or by transformations that leave it room
  /// that of transformations before limits have shortened it; none if they have not
  std::optional<Time_step> time_step;
};

}  // namespace Conformal_geometry_processing::internal
