// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/input/Defects.h"
#include "conformal/input/Surface_input.h"
#include "conformal/report/Session.h"

#include <optional>
#include <string>

namespace conformal {

/// \brief Reads the input surface of a command, with or without a boundary, and adds it to the
/// report.
/// \throws Read_error; Failure for unsuitable surfaces, or with `--advanced strict` for repaired
/// ones
/// \param flat_faces whether it may have faces of area zero
Surface_input read_suitable_surface(const std::string& path, Session& session,
                                    Flat_faces flat_faces = Flat_faces::refused);

/// what `--mollify` makes of faces of area zero
inline Flat_faces flat_faces(const std::optional<double>& mollification)
{
  return mollification ? Flat_faces::allowed : Flat_faces::refused;
}

/// Likewise, for surfaces with a boundary only (of components, that is required when their turn
/// comes)
Surface_input read_bounded_surface(const std::string& path, Session& session);

/// \throws Failure if the surface is closed
void require_boundary(const Surface_input& input);

}  // namespace conformal
