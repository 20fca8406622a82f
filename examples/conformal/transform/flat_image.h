// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_TRANSFORM_FLAT_IMAGE_H
#define CONFORMAL_TRANSFORM_FLAT_IMAGE_H

#include "Flatten_options.h"

#include "conformal/input/Surface_input.h"
#include "conformal/report/Session.h"

#include <string>

namespace conformal {

/// a surface mapped to the plane
struct Flat_image {
  CGP::Points positions;  ///< 3 x |V|, in units of the mesh; z is 0, or nearly
  std::string fault;      ///< why it cannot be trusted, with what to try; empty if it can
};

/// Maps a surface with boundary to the plane, and reports the quality, also in a table.
/// \throws Failure if the options do not fit it, and exceptions of the library
Flat_image flat_image(const Surface_input& input, const Flatten_options& options, Session& session);

}  // namespace conformal

#endif
