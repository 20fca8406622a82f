// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_FLOW_TIME_STEP_H
#define CONFORMAL_GEOMETRY_PROCESSING_FLOW_TIME_STEP_H

#include <algorithm>

namespace Conformal_geometry_processing {

/// \ingroup PkgFlow
/// \brief the time step of a flow that backs off where it must, and then grows again.
///
/// The largest one is tried first. Growing by less than halving undoes keeps a flow that is
/// limited by its step from failing every other time.
class Time_step {
 public:
  /// \pre 0 < smallest <= largest
  Time_step(double largest, double smallest);

  double value() const { return m_value; }

  /// after a step that failed; returns false, and stays, where half the step would be too small
  bool halve();

  /// after a step that succeeded
  void grow() { m_value = (std::min)(1.5 * m_value, m_largest); }

 private:
  double m_largest, m_smallest, m_value;
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/flow/Time_step_impl.h>
#endif

#endif
