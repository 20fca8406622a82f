// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Pictures.h"

#include "conformal/io/file/snapshot_path.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace conformal {

void Pictures::take(const Curve_flows& flows, int step)
{
  if (m_options.animate && step % std::max(m_options.every, 1) == 0)
    m_frames.push_back(flows.curves());
  else if (!m_options.animate && step > 0 && m_options.every > 0 && step % m_options.every == 0)
    write_snapshot(flows, step);
}

void Pictures::write_result(const Curve_flows& flows)
{
  const std::string& output = m_session.options().output;
  if (!m_options.animate) return write_plane_curves(output, flows.curves());
  m_frames.push_back(flows.curves());  // the last one stays a little longer
  write_animation(output, m_frames, m_options.seconds);
}

void Pictures::write_snapshot(const Curve_flows& flows, int step)
{
  const std::string path = snapshot_path(m_session.options().output, step);
  std::error_code ignored;
  if (std::filesystem::equivalent(path, m_options.input, ignored))
    return m_session.note(path + " is not written: it is the input");
  write_plane_curves(path, flows.curves());
}

}  // namespace conformal
