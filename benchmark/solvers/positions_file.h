// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <fstream>
#include <stdexcept>
#include <string>

/// Positions go from the process that makes the reference to those that are compared to it.
namespace cgp_benchmark {

namespace CGP = Conformal_geometry_processing;

inline void write_positions(const std::string& path, const CGP::Points& positions)
{
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(positions.data()),
             static_cast<std::streamsize>(sizeof(double)) * positions.size());
  if (!file) throw std::runtime_error("cannot write " + path);
}

inline CGP::Points read_positions(const std::string& path)
{
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  CGP::Points positions(3, static_cast<std::streamoff>(file.tellg()) /
                               static_cast<std::streamoff>(3 * sizeof(double)));
  file.seekg(0);
  file.read(reinterpret_cast<char*>(positions.data()),
            static_cast<std::streamsize>(sizeof(double)) * positions.size());
  if (!file) throw std::runtime_error("cannot read " + path);
  return positions;
}

}  // namespace cgp_benchmark
