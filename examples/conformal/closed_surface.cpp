// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "closed_surface.h"

#include "Defects.h"
#include "info.h"

namespace conformal {

Surface_input read_closed_surface(const std::string& path, Session& session)
{
  Surface_input input = read_surface_input(path);
  session.end_stage("read");
  session.note_all(input.notes);
  report_input(input, session.report());
  if (session.options().strict) require_untouched(input);
  require_closed_surface(input);
  return input;
}

}  // namespace conformal
