// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Pace.h"

#include <chrono>
#include <utility>

namespace conformal {

Pace::Pace(std::function<double()> now) : m_now(std::move(now)), m_begin(m_now()), m_last(m_begin)
{}

Pace& Pace::of_run()
{
  static Pace pace([] {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
  });
  return pace;
}

}  // namespace conformal
