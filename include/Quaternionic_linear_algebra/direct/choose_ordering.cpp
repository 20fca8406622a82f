// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/direct/choose_ordering.h>

#include <Quaternionic_linear_algebra/direct/Ordering.h>
#include <Quaternionic_linear_algebra/direct/sweep_nested_dissection.h>

#include <cmath>
#include <optional>
#include <utility>

namespace Conformal_geometry_processing {
namespace internal {

// Returns whether dissection may save more than it takes.
bool dissection_may_pay(const Elimination& by_degree, double n, int factorizations,
                        const Ordering_costs& costs)
{
  const double operations = by_degree.operations();
  return operations > costs.limbs * std::pow(n, 1.5) &&
         costs.expected_saving * factorizations * operations * costs.seconds_per_operation >
             costs.seconds_per_vertex * n;
}

}  // namespace internal

internal::Elimination choose_elimination(const Sparse_pattern& pattern,
                                         const Eigen::Matrix3Xd* positions, int factorizations,
                                         const internal::Ordering_costs& costs)
{
  if (positions == nullptr) return internal::Elimination(pattern, amd_ordering(pattern));
  std::optional<internal::Elimination> by_degree;
  const auto find_by_degree = [&]() -> const internal::Ordering* {
    by_degree.emplace(pattern, amd_ordering(pattern));
    const bool may_pay =
        internal::dissection_may_pay(*by_degree, pattern.size(), factorizations, costs);
    return may_pay ? &by_degree->order() : nullptr;
  };
  const internal::Ordering dissected = sweep_nested_dissection(pattern, *positions, find_by_degree);
  if (dissected.empty()) return *std::move(by_degree);
  internal::Elimination by_dissection(pattern, dissected);
  if (by_dissection.operations() < by_degree->operations()) return by_dissection;
  return *std::move(by_degree);
}

std::shared_ptr<const internal::Supernodal_structure> choose_structure(
    const Sparse_pattern& pattern, const Eigen::Matrix3Xd* positions, int factorizations,
    const internal::Ordering_costs& costs)
{
  return std::make_shared<const internal::Supernodal_structure>(
      pattern, choose_elimination(pattern, positions, factorizations, costs));
}

internal::Ordering choose_ordering(const Sparse_pattern& pattern, const Eigen::Matrix3Xd* positions,
                                   int factorizations, const internal::Ordering_costs& costs)
{
  return choose_elimination(pattern, positions, factorizations, costs).order();
}

}  // namespace Conformal_geometry_processing
