// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "suitable_surface.h"

#include "Component.h"

#include "conformal/process/Failure.h"
#include "conformal/report/report_input.h"

#include <Conformal_geometry_processing/mesh/topology.h>

namespace conformal {

Surface_input read_suitable_surface(const std::string& path, Session& session,
                                    Flat_faces flat_faces)
{
  Surface_input input = read_surface_input(path, session.options().repair);
  session.set_input(path);
  session.end_stage("read");
  const bool is_whole = !session.options().each_component;
  if (!is_whole) turn_components_outward(input);
  session.note_all(input.notes);
  report_input(input, session.report());
  if (session.options().strict) require_untouched(input);
  // A face of area zero is a fault of its component, which the others need not share.
  const Flat_faces of_parts = session.options().keep_going ? Flat_faces::allowed : flat_faces;
  is_whole ? require_surface(input, flat_faces) : require_surface_components(input, of_parts);
  return input;
}

Surface_input read_bounded_surface(const std::string& path, Session& session)
{
  Surface_input input = read_suitable_surface(path, session);
  if (!session.options().each_component) require_boundary(input);
  return input;
}

void require_boundary(const Surface_input& input)
{
  if (CGP::topology(input.mesh).is_closed())
    throw unsuitable(input.file.path,
                     "the surface is closed, one with a boundary is wanted; try: conformal "
                     "spin, or cut it open (conformal flatten --cut)");
}

}  // namespace conformal
