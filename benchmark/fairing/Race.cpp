// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Race.h"

#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/measure/energies.h>

#include <algorithm>

#include "../support/clock.h"

namespace cgp_benchmark {
namespace {

// Of the energy: relative to the minimum so far, and to the previous one, to detect divergence.
const double tolerance = 0.01, explosion = 4;

const int most_moments = 100;  // at which a surface is measured

}  // namespace

Race::Race(const CGP::Mesh_view& mesh, double seconds, int max_steps)
    : m_initial(mesh), m_mesh(mesh), m_budget(seconds), m_max_steps(max_steps)
{
  m_run.positions = mesh.positions();
  m_least = m_first = CGP::willmore_energy(mesh);
  m_start = cpu_seconds();
}

bool Race::operator()(const CGP::Points& positions)
{
  const double seconds = cpu_seconds() - m_start;
  if (seconds > m_budget) return false;
  ++m_run.steps;
  const bool is_last = m_run.steps == m_max_steps;
  if (seconds < m_next && !is_last) return positions.allFinite() || fail("not finite");
  if (std::isfinite(m_budget)) m_next = seconds + m_budget / most_moments;
  m_mesh.set_positions(positions);
  const double energy = CGP::willmore_energy(m_mesh);
  if (!positions.allFinite() || !std::isfinite(energy)) return fail("not finite");
  m_run.curve.push_back({seconds, energy});
  m_run.positions = positions;
  m_run.worst_q = std::max(m_run.worst_q, CGP::quasi_conformal_error(m_initial, positions).mean);
  m_run.is_stable = m_run.is_stable && energy <= (1 + tolerance) * m_least;
  m_least = std::min(m_least, energy);
  if (energy > explosion * m_first) return fail("energy explodes");
  m_start = cpu_seconds() - seconds;
  if (is_last) finish("all steps are done");
  return !is_last;
}

}  // namespace cgp_benchmark
