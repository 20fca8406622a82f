// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Curve_flows.h"
#include "Curve_options.h"

#include "conformal/io/write_plane_curves.h"
#include "conformal/report/Session.h"

#include <vector>

namespace conformal {

/// Takes pictures on the way: files of their own, or the frames of an animation.
class Pictures {
 public:
  Pictures(const Curve_options& options, Session& session) : m_options(options), m_session(session)
  {}

  void take(const Curve_flows& flows, int step);
  void write_result(const Curve_flows& flows);

 private:
  void write_snapshot(const Curve_flows& flows, int step);

  const Curve_options& m_options;
  Session& m_session;
  std::vector<Curve_picture> m_frames;
};

}  // namespace conformal
