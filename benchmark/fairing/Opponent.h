// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/measure/energies.h>
#include <Conformal_geometry_processing/mesh/normals.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "../support/Record.h"
#include "../support/workloads.h"
#include "Method.h"
#include "modified_mean_curvature.h"

namespace cgp_benchmark {

/// what a surface is judged by, on the faces of the input
struct Judgement {
  double energy = HUGE_VAL, q_mean = HUGE_VAL;

  /// at most so much of both that another one has; below 1 where it is better in both
  double by(const Judgement& other) const
  {
    return std::max(energy / other.energy, q_mean / other.q_mean);
  }
};

inline Judgement judgement(const CGP::Mesh_view& initial, const CGP::Points& positions)
{
  return {CGP::willmore_energy(CGP::Mesh_view(positions, initial.corners())),
          CGP::quasi_conformal_error(initial, positions).mean};
}

/// \brief Keeps, of all surfaces of a method, the one that comes nearest to be better than a given
/// one in energy and angles.
class Opponent : public Surface_observer {
 public:
  Opponent(const CGP::Mesh_view& initial, const Judgement& given)
      : m_initial(initial), m_given(given)
  {}

  bool operator()(const CGP::Points& positions) override
  {
    const CGP::Points now = positions_in_unit_frame({positions, m_initial.corners()});
    ++m_steps;
    if (!now.allFinite()) return false;
    if (const Judgement found = judgement(m_initial, now); found.by(m_given) < m_best.by(m_given)) {
      m_best = found;
      m_positions = now;
      m_best_time_step = m_time_step;
      m_best_steps = m_steps;
    }
    const double move = m_last.cols() > 0 ? (now - m_last).cwiseAbs().maxCoeff() : HUGE_VAL;
    m_last = now;
    return m_steps < most_steps && move > arrived;
  }

  /// runs a flow with one time step after another
  template <class Flow>
  void run(const Flow& flow)
  {
    for (const double time_step : {10., 1., .1, .01}) {
      m_time_step = time_step;
      m_steps = 0;
      try {
        flow(m_initial, time_step, *this);
      } catch (const CGP::Error&) {  // thin faces: what came before counts
      }
    }
  }

  void print(Record record) const
  {
    if (m_positions.cols() == 0) return;
    record.add("time_step", m_best_time_step).add("steps", m_best_steps);
    describe(m_positions, std::move(record));
  }

  void describe(const CGP::Points& positions, Record record) const
  {
    const CGP::Conformality map =
        CGP::conformality(m_initial, positions, CGP::neighbourhood_normals(m_initial, positions));
    record.add("energy", CGP::willmore_energy(CGP::Mesh_view(positions, m_initial.corners())));
    record.add("q_mean", map.quasi_conformal.mean).add("q_max", map.quasi_conformal.max);
    record.add("flips", map.flipped_faces).print();
  }

 private:
  static constexpr int most_steps = 60;
  static constexpr double arrived = 1e-6;  // of the radius: no vertex moves further

  CGP::Mesh_view m_initial;
  Judgement m_given, m_best;
  CGP::Points m_positions, m_last;
  double m_time_step = 0, m_best_time_step = 0;
  int m_steps = 0, m_best_steps = 0;
};

/// \brief prints what a result is, and how near two flows come to be better than it, on the faces
/// of the result: those of the mesh, oriented.
///
/// These converge to the conformal map to the sphere, where there is one.
inline void compare_with_opponents(const std::string& path, const std::string& result)
{
  const CGP::Mesh_view after = make_mesh(result);
  const CGP::Mesh_view mesh = in_unit_frame({read_off(path).positions(), after.corners()});
  const CGP::Points& positions = after.positions();
  const Judgement given = judgement(mesh, positions);
  const auto record = [](const std::string& name) { return Record().add("method", name); };
  Opponent(mesh, given).describe(mesh.positions(), record("before"));
  Opponent(mesh, given).describe(positions, record("flow"));
  Opponent cmcf(mesh, given), smooth_shape(mesh, given);
  cmcf.run(run_steps<Modified_mean_curvature>);
  cmcf.print(record("cMCF"));
  smooth_shape.run(run_smooth_shape);
  smooth_shape.print(record("smooth_shape"));
}

}  // namespace cgp_benchmark
