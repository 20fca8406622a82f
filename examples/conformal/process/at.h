// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstddef>

namespace conformal {

/// the place of an element in a container: the kernels number elements by `int`
inline std::size_t at(int i)
{
  return static_cast<std::size_t>(i);
}

}  // namespace conformal
