// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace cgp_benchmark {

namespace CGP = Conformal_geometry_processing;

/// the mesh without the vertices that no face has; the others keep their order
inline CGP::Mesh_view without_stray_vertices(const CGP::Points& points,
                                             CGP::Mesh_view::Corners corners)
{
  std::vector<int> number(static_cast<std::size_t>(points.cols()), -1);
  for (const auto& face : corners)
    for (const int v : face) number.at(static_cast<std::size_t>(v)) = 0;
  int used = 0;
  for (int& n : number)
    if (n == 0) n = used++;
  CGP::Points compact(3, used);
  for (int v = 0; v < points.cols(); ++v)
    if (const int n = number[static_cast<std::size_t>(v)]; n >= 0) compact.col(n) = points.col(v);
  for (auto& face : corners)
    for (int& v : face) v = number[static_cast<std::size_t>(v)];
  return {std::move(compact), std::move(corners)};
}

/// a triangle mesh in the format OFF
inline CGP::Mesh_view read_off(const std::string& path)
{
  std::ifstream file(path);
  std::stringstream words;
  for (std::string line; std::getline(file, line);) words << line.substr(0, line.find('#')) << '\n';
  std::string magic;
  int vertices = 0, faces = 0, edges = 0;
  words >> magic >> vertices >> faces >> edges;
  if (!words || magic != "OFF") throw std::runtime_error(path + " is no OFF file");
  CGP::Points points(3, vertices);
  for (int v = 0; v < vertices; ++v) words >> points(0, v) >> points(1, v) >> points(2, v);
  CGP::Mesh_view::Corners corners(static_cast<std::size_t>(faces));
  for (auto& face : corners) {
    int degree = 0;
    words >> degree >> face[0] >> face[1] >> face[2];
    if (!words || degree != 3) throw std::runtime_error(path + " is not a triangle mesh");
  }
  return without_stray_vertices(points, std::move(corners));
}

}  // namespace cgp_benchmark
