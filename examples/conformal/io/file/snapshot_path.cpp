// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "snapshot_path.h"

namespace conformal {

std::string snapshot_path(const std::string& output, int step)
{
  std::string number = std::to_string(step);
  number.insert(0, number.size() < 4 ? 4 - number.size() : 0, '0');
  const std::size_t dot = output.rfind('.');
  return output.substr(0, dot) + "_" + number + output.substr(dot);
}

}  // namespace conformal
