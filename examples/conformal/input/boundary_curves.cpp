// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "boundary_curves.h"

#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/number_rows.h"
#include "conformal/io/file/read_bytes.h"
#include "conformal/process/Failure.h"
#include "conformal/process/text.h"

#include <Conformal_geometry_processing/mesh/topology.h>

#include <utility>

namespace conformal {
namespace {

using Points_of_curve = std::vector<Eigen::Vector3d>;

Eigen::Vector3d point_of(const Number_row& row, const std::string& path)
{
  const std::size_t size = row.numbers.size();
  if (size != 2 && size != 3)
    throw Read_error(path, row.line,
                     count_of(size, "number") + ", wanted two or three coordinates of a point");
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < size; ++i) p[static_cast<Eigen::Index>(i)] = row.numbers[i];
  if (!p.allFinite()) throw Read_error(path, row.line, "coordinates that are not finite");
  return p;
}

void finish(Points_of_curve& points, std::size_t line, const std::string& path,
            std::vector<Closed_curve>& curves)
{
  if (points.empty()) return;
  if (points.size() > 1 && points.front() == points.back()) points.pop_back();
  if (points.size() < 3)
    throw Read_error(path, line,
                     "a curve of " + count_of(points.size(), "point") + ", wanted three at least");
  CGP::Points all(3, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) all.col(static_cast<Eigen::Index>(i)) = points[i];
  curves.emplace_back(std::move(all));
  points.clear();
}

/// the points of the curve that belong to the vertices of the loop
CGP::Points matched(const Closed_curve& curve, const Closed_curve& loop)
{
  const Eigen::Index n = loop.points().cols();
  if (curve.points().cols() == n) return curve.points();
  CGP::Points points(3, n);
  for (Eigen::Index k = 0; k < n; ++k)
    points.col(k) = curve(loop.shares()[static_cast<std::size_t>(k)]);
  return points;
}

}  // namespace

std::vector<Closed_curve> read_curves(const std::string& path)
{
  std::vector<Closed_curve> curves;
  Points_of_curve points;
  std::size_t line = 0;
  for (const Number_row& row : number_rows(read_bytes(path, "a file with points"), path)) {
    line = row.line;
    if (!row.numbers.empty())
      points.push_back(point_of(row, path));
    else if (!row.has_comment)
      finish(points, line, path, curves);
  }
  finish(points, line, path, curves);
  return curves;
}

CGP::Points tangents_of_curves(const Surface_input& input, const std::string& path)
{
  const std::vector<Closed_curve> curves = read_curves(path);
  const std::vector<std::vector<int>> loops = CGP::boundary_loops(input.mesh);
  if (curves.size() != loops.size())
    throw unsuitable(path, "has " + count_of(curves.size(), "curve") + ", wanted one for each of " +
                               count_of(loops.size(), "boundary loop"));
  CGP::Points all(3, 0);
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const CGP::Points T = tangents(matched(curves[l], {input.mesh, loops[l]}));
    for (Eigen::Index k = 0; k < T.cols(); ++k)
      if (!(T.col(k).stableNorm() > 0))
        throw unsuitable(path, "curve " + std::to_string(l) + " has no direction at " +
                                   name_of_vertex(input, loops[l][static_cast<std::size_t>(k)]) +
                                   "; try: more points, and none twice");
    const Eigen::Index first = all.cols();
    all.conservativeResize(3, first + T.cols());
    all.rightCols(T.cols()) = T;
  }
  return all;
}

}  // namespace conformal
