// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Scale_bound.h>

#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Period_residual.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace Conformal_geometry_processing::internal {

Eigen::VectorXd vertex_log_scales(const Mesh_view& before, const Points& after)
{
  const auto log_scale = [&](int i, int j) {
    const double length = (before.position(j) - before.position(i)).norm();
    return std::log((after.col(j) - after.col(i)).norm() / length);
  };
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(after.cols()), faces = sum;
  for (const auto& v : before.corners()) {
    const Eigen::Vector3d opposite(log_scale(v[1], v[2]), log_scale(v[2], v[0]),
                                   log_scale(v[0], v[1]));
    for (int c = 0; c < 3; ++c) {
      const int vertex = v[static_cast<std::size_t>(c)];
      sum[vertex] += opposite.sum() - 2 * opposite[c];
      ++faces[vertex];
    }
  }
  return sum.cwiseQuotient(faces);
}

Scale_bound::Scale_bound(const Mesh_view& initial, double bound)
    : m_initial(initial), m_areas(vertex_areas(initial)), m_control{bound, {}, {}}
{}

/// spins that multiply lengths by exp(u)
Quaternion_vector<double> spins_of(const Eigen::VectorXd& u)
{
  Quaternion_vector<double> lambda(u.size());
  for (Eigen::Index v = 0; v < u.size(); ++v) lambda[v] = {std::exp(u[v] / 2), 0, 0, 0};
  return lambda;
}

Spin_report::Scales Scale_bound::measured(const Points& positions) const
{
  return measured_scales(spins_of(vertex_log_scales(m_initial, positions)), m_areas, m_control);
}

// By the areas of the surface, which its factors have only to the discretisation error, the same
// lengths are not at the same part of the bound: what is asked for is the difference.
Scale_control Scale_bound::control(const Mesh_view& surface, double retreat) const
{
  const Eigen::VectorXd u = vertex_log_scales(m_initial, surface.positions());
  const Eigen::VectorXd areas = vertex_areas(surface);
  Scale_control control = m_control;
  control.factors = (-u).array().exp();
  control.weights = m_areas.cwiseQuotient(areas);
  control.counted_areas = m_areas;
  const auto unmoved = spins_of(Eigen::VectorXd::Zero(u.size()));
  const double there = measured_scales(unmoved, areas, control).excess();
  const double left = 1 - measured(surface.positions()).excess(), least = .5;
  control.bound = std::pow(*m_control.bound, (std::max)(there + left - retreat, least));
  return control;
}

// Lengths may keep to the bound with several weights, where a limb moves much by a small rho: with
// large ones it is led back beyond where it was, against rho. A small weight leads to the nearest.
bool Scale_bound::find(Relaxed_scales& search, const Eigen::VectorXd& rho, double time,
                       const std::function<bool(const Eigensolver_progress&)>& go_further)
{
  const Quaternion_vector<double>& rest = search.spins().start();
  const double excess = search.excess();
  bool descends = false;
  for (const double weight : {m_pace.weight, Pace().weight}) {
    if (descends) break;
    search.restart({rest, rho, time * weight, excess});
    if (search.follow(rho, go_further) == Relaxed_scales::End::cancelled) return true;
    descends = search.scales().kept_correlation > 0;
  }
  m_pace.weight = search.weight() / time;
  return descends;
}

std::optional<Spin_result> Scale_bound::step(
    Spin_transformation& transformation, const Mesh_view& surface, const Eigen::VectorXd& rho,
    double time, const std::function<bool(const Eigensolver_progress&)>& go_further)
{
  const Scale_control bounded = control(surface, time * m_pace.retreat);
  std::optional<Period_residual> periods;
  Spin_residuals closing;
  if (const Exactness_constraints* loops = transformation.closing())
    closing.push_back(&periods.emplace(transformation.system().surface(), *loops));
  const Eigen::VectorXd in_frame = transformation.domain().unit() * rho;
  Relaxed_scales search(transformation.system(), in_frame, bounded, closing, options(time));
  if (!find(search, in_frame, time, go_further)) return std::nullopt;
  if (periods && search.steps() > 0) search.meet_few(true);
  return transformation.surface_of(search.solution());
}

// The energy falls by the inner product of rho and rho' over the area, so rho' is the nearest by
// that: the nearest by another one may have more energy. All that is asked for of lengths tends to
// zero with the step, or the smallest one would still move them.
Relaxed_scales_options Scale_bound::options(double time)
{
  Relaxed_scales_options options;
  options.spins.smoothness = 0;
  options.last_tolerance = .02;
  options.least_weight *= time;
  options.closeness *= time;
  return options;
}

void Scale_bound::learn(const Points& positions, double time)
{
  const double beyond = measured(positions).excess() - 1, safety = .2;
  const double least =
      Relaxed_scales_options().closeness / 2;  // or it takes many steps to be below
  const double change =
      beyond > 0 ? (1 + safety) * beyond / time + least : (1 - safety) * beyond / time;
  m_pace.retreat = (std::max)(0., m_pace.retreat + change);
}

}  // namespace Conformal_geometry_processing::internal
