// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <functional>

namespace conformal {

/// The clock of a run, and when the next object of its progress is due.
class Pace {
 public:
  /// \param now seconds since any moment
  explicit Pace(std::function<double()> now);

  /// that of this run, which began when this was first called
  static Pace& of_run();

  /// since it began
  double seconds() const { return m_now() - m_begin; }

  /// whether so many seconds have gone since it began, and since a line was told last
  bool is_due(double interval) const { return m_now() - m_last >= interval; }

  void line_is_told() { m_last = m_now(); }

 private:
  std::function<double()> m_now;
  double m_begin, m_last;
};

}  // namespace conformal
