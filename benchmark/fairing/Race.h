// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace cgp_benchmark {

namespace CGP = Conformal_geometry_processing;

/// Result of a method on a surface
struct Run {
  struct Moment {
    double seconds, energy;
  };
  double time_step = 0;
  int steps = 0;
  std::vector<Moment> curve;
  CGP::Points positions;  // at the last moment
  double worst_q = 1;     // the greatest mean quasi-conformal error on the way
  bool is_stable = true;
  std::string end = "time is up";

  double seconds() const { return curve.empty() ? 0 : curve.back().seconds; }
  double energy() const { return curve.empty() ? HUGE_VAL : curve.back().energy; }
};

/// takes the surfaces of a method one by one
class Surface_observer {
 public:
  virtual ~Surface_observer() = default;

  /// takes the surface after a step
  /// \returns whether to go on
  virtual bool operator()(const CGP::Points& positions) = 0;
};

/// \brief Observes a method step by step, and stops it when its time is over.
///
/// The clock starts at construction, so that setup counts, and is paused while the surface is
/// measured: after every step, or a hundred times if there are more. A step that ends too late does
/// not count. A run is *stable* if every number is finite, every system was solved, and the
/// Willmore energy never exceeds the minimum so far by more than 1 %.
class Race : public Surface_observer {
 public:
  Race(const CGP::Mesh_view& mesh, double seconds, int max_steps);

  bool operator()(const CGP::Points& positions) override;

  /// Records why there is no further step, as a failure
  bool fail(std::string why)
  {
    m_run.end = std::move(why);
    return m_run.is_stable = false;
  }

  /// Records why there is no further step
  void finish(std::string why) { m_run.end = std::move(why); }

  Run result() && { return std::move(m_run); }

 private:
  CGP::Mesh_view m_initial, m_mesh;
  double m_budget;
  int m_max_steps;
  double m_start, m_least, m_first;
  double m_next = 0;  // when to measure again
  Run m_run;
};

}  // namespace cgp_benchmark
