// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Which surface has prescribed directions and closes up around holes.
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <Conformal_geometry_processing/spin/Directions_selection.h>
#include <Conformal_geometry_processing/spin/Relaxed_surface.h>

#include <Eigen/Core>

#include <algorithm>
#include <utility>
#include <vector>

namespace Conformal_geometry_processing {
namespace internal {

/// a vector of the kernel
struct Kernel_vector {
  Eigen::Index column;
  double change;   // of rho with which it closes up
  double overlap;  // with the guide
};

inline Closing_start chosen(std::vector<Kernel_vector> found,
                            const Block<Quaternion<double>>& kernel)
{
  const double clearly = 2;  // larger
  if (found.size() < 2) return {};
  std::sort(found.begin(), found.end(),
            [](const Kernel_vector& a, const Kernel_vector& b) { return a.change < b.change; });
  const bool is_guided = std::all_of(found.begin(), found.end(), [&](const Kernel_vector& other) {
    return other.overlap <= found.front().overlap;
  });
  Closing_start start;
  start.is_ambiguous = found[1].change < clearly * found[0].change;
  if (!is_guided) start.lambda = kernel.col(found.front().column);
  return start;
}

}  // namespace internal

Block<Quaternion<double>> Spin_transformation::kernel(const Curvature_potential& rho,
                                                      const internal::Go_further& go_further)
{
  internal::Dirac_solution costs;
  system().set_potential(rho, costs.seconds);
  costs.factorizations = 1;
  auto vectors =
      internal::Directions_selection(system(), rho, m_options.dirac).kernel(costs, go_further);
  internal::add_costs(m_unreported, in_units(std::move(costs)).report);
  return vectors;
}

internal::Closing_start Spin_transformation::closing_start(const Eigen::VectorXd& rho,
                                                           const internal::Go_further& go_further)
{
  if (!turns_directions() || !closing()) return {};
  const internal::Go_further guarded = m_visits.guarded(go_further);
  const Block<Quaternion<double>> vectors = kernel(Curvature_potential::on_vertices(rho), guarded);
  const internal::Scale_control unbounded;
  internal::Relaxed_surface search(*this, rho, unbounded, internal::Closing_start::few_steps());
  std::vector<internal::Kernel_vector> found;
  for (Eigen::Index c = 0; c < vectors.cols(); ++c) {
    search.begin_at(vectors.col(c), rho, guarded);
    found.push_back({c, search.scales().spins().terms().potential,
                     system().overlap(vectors.col(c), system().directions()->guide())});
  }
  internal::add_costs(m_unreported, in_units(search.scales().solution()).report);
  return internal::chosen(std::move(found), vectors);
}

}  // namespace Conformal_geometry_processing
