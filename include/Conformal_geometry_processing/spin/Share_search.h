// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/spin/Spin_result.h>

#include <functional>
#include <utility>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgSpin
/// \brief applies as much of rho as a surface bears: all of it, or a half, a quarter, an eighth
/// where its edges or handles stay open, lengths stay beyond their bound or the map is not
/// conformal; from there, as a little more of rho shall not mean that half of it is applied, it
/// goes on to more of it, by bisection.
/// \tparam Place where an attempt may begin: what another one has found
template <class Place>
class Share_search {
 public:
  struct Attempt {
    Spin_result result;
    Place place;
  };

  /// a share of rho, and where to begin: what was found for a smaller one, or null
  using Try = std::function<Attempt(double share, const Place* from)>;

  explicit Share_search(Try attempt) : m_try(std::move(attempt)) {}

  /// \param share to begin with; a larger one counts as too much
  Spin_result run(double share)
  {
    m_share = share;
    m_too_much = share < 1 ? 1 : 0;
    m_best = m_try(share, nullptr);
    while (m_share > least && is_too_much(m_best.result.report.fault())) take_half();
    for (int i = 0; i < 2 && m_too_much > 0 && m_best.result.report; ++i)
      if (!take_more()) break;
    return std::move(m_best.result);
  }

 private:
  static constexpr double least = 1. / 8;

  static bool is_too_much(Spin_report::Fault fault)
  {
    using Fault = Spin_report::Fault;
    return fault == Fault::open || fault == Fault::scales || fault == Fault::map;
  }

  void take_half()
  {
    m_too_much = m_share;
    m_share /= 2;
    Attempt next = m_try(m_share, nullptr);
    // Of maps that are not conformal, that of most of rho tells most.
    const bool is_map = m_best.result.report.fault() == Spin_report::Fault::map;
    const bool is_better = !is_map || next.result.report;
    take(std::move(next), is_better);
  }

  /// \returns whether it was too much, or is nearer to rho; otherwise still more is in vain
  bool take_more()
  {
    const double middle = (m_share + m_too_much) / 2;
    Attempt next = m_try(middle, &m_best.place);
    const Spin_report &now = next.result.report, &before = m_best.result.report;
    const bool is_good(now),
        is_nearer = is_good && now.scales.distance() < before.scales.distance();
    (is_good ? m_share : m_too_much) = middle;
    take(std::move(next), is_nearer);
    return is_nearer || !is_good;
  }

  /// what was cancelled is the last
  void take(Attempt next, bool is_better)
  {
    if (is_better || next.result.report.cancelled) std::swap(m_best, next);
    add_costs(m_best.result.report, next.result.report);
  }

  Try m_try;
  Attempt m_best;
  double m_share = 1, m_too_much = 0;
};

}  // namespace Conformal_geometry_processing::internal
