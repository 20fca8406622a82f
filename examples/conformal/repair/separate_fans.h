// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Corner_fans.h"

#include "conformal/io/data/Surface_file.h"

#include <vector>

namespace conformal {

/// Where the vertices of a file were, the copies last; those without a face are gone.
struct Separated_vertices {
  std::vector<int> vertex_in_file;
  int copies = 0;
};

/// Assigns a separate vertex to every fan of corners, with the point and the properties of the old
/// one: the first fan keeps the old vertex.
Separated_vertices separate_fans(Surface_file& file, const Corner_fans& fans);

}  // namespace conformal
