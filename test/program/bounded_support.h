// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "program/support.h"
#include "support/bounded_meshes.h"

#include "conformal/io/read_surface.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

/// Runs the program on surfaces with boundary.
namespace program_test {

using cgp_test::Points;

class Bounded_program : public Program {
 protected:
  nlohmann::json json(const std::string& name) const { return read_json(name); }

  Points points(const std::string& name) const
  {
    const auto file = conformal::read_surface(path(name));
    Points p(3, static_cast<Eigen::Index>(file.points.size()));
    for (Eigen::Index v = 0; v < p.cols(); ++v)
      p.col(v) = Eigen::Vector3d::Map(file.points[static_cast<std::size_t>(v)].data());
    return p;
  }
};

/// the boundary of `cgp_test::disk(n)`, counterclockwise from the x axis
inline std::vector<int> outer_ring(int n)
{
  std::vector<int> ring;
  for (int j = 0; j < 6 * n; ++j) ring.push_back(1 + 3 * n * (n - 1) + j);
  return ring;
}

/// from the vertex before to the one after, unit vectors
inline Points directions(const Points& p, const std::vector<int>& ring)
{
  const std::size_t n = ring.size();
  Points T(3, static_cast<Eigen::Index>(n));
  for (std::size_t k = 0; k < n; ++k)
    T.col(static_cast<Eigen::Index>(k)) =
        (p.col(ring[(k + 1) % n]) - p.col(ring[(k + n - 1) % n])).normalized();
  return T;
}

/// with their mean at zero
inline Points centred(const Points& p)
{
  const Eigen::Vector3d mean = p.rowwise().mean();
  return p.colwise() - mean;
}

}  // namespace program_test
