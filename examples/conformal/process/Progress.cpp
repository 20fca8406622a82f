// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Progress.h"

#include "text.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace conformal {

Progress::Progress(bool is_quiet) : m_is_shown(!is_quiet && ::isatty(STDERR_FILENO) == 1) {}

void Progress::show(const std::string& stage, double fraction)
{
  if (!m_is_shown) return;
  constexpr int width = 30;
  const double share = std::isfinite(fraction) ? std::clamp(fraction, 0., 1.) : 0;
  const auto filled = static_cast<std::size_t>(std::lround(share * width));
  const std::string bar = std::string(filled, '#') + std::string(width - filled, '.');
  std::fprintf(stderr, "\r\033[K[%s] %s", bar.c_str(), printable_line(stage).c_str());
  std::fflush(stderr);
  m_has_line = true;
}

void Progress::clear()
{
  if (m_has_line) std::fputs("\r\033[K", stderr);
  m_has_line = false;
}

}  // namespace conformal
