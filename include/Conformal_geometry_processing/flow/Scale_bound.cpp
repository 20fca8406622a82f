// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/flow/Scale_bound.h>

#include <Conformal_geometry_processing/operators/mass_matrices.h>
#include <Conformal_geometry_processing/spin/Period_residual.h>
#include <Conformal_geometry_processing/spin/Relaxed_scales.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

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

Scale_control Scale_bound::control(const Mesh_view& surface, double time) const
{
  const double room = .02, aimed_below = Relaxed_scales_options().closeness / 2;
  const double used = measured(surface.positions()).excess();
  const double kept = (std::min)(used * (1 + aimed_below) - time * room, 1.);
  Scale_control control;
  control.bound = std::pow(*m_control.bound, (std::max)(1 - room, kept));
  const Eigen::VectorXd u = vertex_log_scales(m_initial, surface.positions());
  control.factors = (-u).array().exp();
  control.weights = m_areas.cwiseQuotient(vertex_areas(surface));
  control.counted_areas = m_areas;
  return control;
}

Spin_result Scale_bound::step(
    Spin_transformation& transformation, const Mesh_view& surface, const Eigen::VectorXd& rho,
    double time, const std::function<bool(const Eigensolver_progress&)>& go_further) const
{
  const Scale_control bounded = control(surface, time);
  std::optional<Period_residual> periods;
  Spin_residuals closing;
  if (const Exactness_constraints* loops = transformation.closing())
    closing.push_back(&periods.emplace(transformation.system().surface(), *loops));
  // Weights that do not become small with the step would lead lengths back that rho does not move.
  const double weight = .03 * time;
  Relaxed_scales_options options;
  options.least_weight *= time;
  const Eigen::VectorXd in_frame = transformation.domain().unit() * rho;
  Relaxed_scales search(transformation.system(), in_frame, bounded, closing, options);
  search.restart({search.spins().start(), in_frame, weight, search.excess()});
  search.follow(in_frame, go_further);
  if (periods && search.steps() > 0) search.meet_few(true);
  return transformation.surface_of(search.solution());
}

}  // namespace Conformal_geometry_processing::internal
