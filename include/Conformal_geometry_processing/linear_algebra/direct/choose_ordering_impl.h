// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_CHOOSE_ORDERING_IMPL_H
#define CONFORMAL_GEOMETRY_PROCESSING_LINEAR_ALGEBRA_DIRECT_CHOOSE_ORDERING_IMPL_H

#include <Conformal_geometry_processing/config.h>
#include <Conformal_geometry_processing/linear_algebra/direct/Ordering.h>
#include <Conformal_geometry_processing/linear_algebra/direct/choose_ordering.h>
#include <Conformal_geometry_processing/linear_algebra/direct/sweep_nested_dissection.h>

#include <Eigen/Core>

#include <cmath>
#include <memory>

namespace Conformal_geometry_processing {
namespace internal {

CGP_INLINE Structure_choice::Structure_choice(const Sparse_pattern& pattern, int factorizations,
                                              const Ordering_costs& costs)
    : m_pattern(pattern), m_costs(costs), m_factorizations(factorizations)
{}

CGP_INLINE Structure_choice::Structure Structure_choice::by_degree() const
{
  return std::make_shared<const Supernodal_structure>(m_pattern, amd_ordering(m_pattern));
}

CGP_INLINE Structure_choice::Structure Structure_choice::by_dissection(
    const Eigen::Matrix3Xd& positions) const
{
  return std::make_shared<const Supernodal_structure>(
      m_pattern, sweep_nested_dissection(m_pattern, positions));
}

// Returns whether a trial of this duration may save more than it costs.
CGP_INLINE bool Structure_choice::may_save(const Structure& other, double seconds_per_vertex) const
{
  return m_costs.expected_saving * m_factorizations * other->operations() *
             m_costs.seconds_per_operation >
         seconds_per_vertex * m_pattern.size();
}

CGP_INLINE bool Structure_choice::is_compact_surface(const Structure& by_dissection) const
{
  const double constant = by_dissection->operations() / std::pow(m_pattern.size(), 1.5);
  return m_costs.compact < constant && constant < m_costs.not_a_surface;
}

CGP_INLINE Structure_choice::Structure Structure_choice::better(Structure a, Structure b)
{
  return b->operations() < a->operations() ? b : a;
}

}  // namespace internal

CGP_INLINE std::shared_ptr<const internal::Supernodal_structure> choose_structure(
    const Sparse_pattern& pattern, const Eigen::Matrix3Xd* positions, int factorizations,
    const internal::Ordering_costs& costs)
{
  const internal::Structure_choice choice(pattern, factorizations, costs);
  if (positions == nullptr) return choice.by_degree();
  if (pattern.size() < costs.large) {
    const auto first = choice.by_degree();
    return choice.may_save(first, costs.seconds_per_vertex)
               ? choice.better(first, choice.by_dissection(*positions))
               : first;
  }
  const auto first = choice.by_dissection(*positions);
  return !choice.is_compact_surface(first) &&
                 choice.may_save(first, costs.seconds_per_vertex_by_degree)
             ? choice.better(first, choice.by_degree())
             : first;
}

CGP_INLINE internal::Ordering choose_ordering(const Sparse_pattern& pattern,
                                              const Eigen::Matrix3Xd* positions, int factorizations,
                                              const internal::Ordering_costs& costs)
{
  return choose_structure(pattern, positions, factorizations, costs)->order();
}

}  // namespace Conformal_geometry_processing

#endif
