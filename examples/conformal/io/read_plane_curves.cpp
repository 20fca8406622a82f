// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "read_plane_curves.h"

#include "conformal/io/csv/read_curve_rows.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/read_bytes.h"
#include "conformal/io/svg/read_svg.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace conformal {
namespace {

std::vector<Plane_curve> parse(Curve_format format, const std::string& path,
                               const Curve_reading& reading, std::vector<std::string>& notes)
{
  const std::string bytes = read_bytes(path, "a file with curves");
  switch (format) {
    case Curve_format::svg:
      return parse_svg(bytes, path, reading, notes);
    case Curve_format::obj:
      return parse_obj_lines(bytes, path);
    default:
      return parse_curve_rows(bytes, path);
  }
}

double longest_edge(const Eigen::Matrix2Xd& points)
{
  double longest = 0;
  for (Eigen::Index i = 0; i + 1 < points.cols(); ++i)
    longest = std::max(longest, (points.col(i + 1) - points.col(i)).norm());
  return longest;
}

bool looks_closed(const Plane_curve& curve, Curve_format format)
{
  const Eigen::Index last = curve.points.cols() - 1;
  if (curve.is_closed || last < 2) return curve.is_closed;
  const double gap = (curve.points.col(last) - curve.points.col(0)).norm();
  return gap == 0 || (format == Curve_format::csv && gap <= longest_edge(curve.points));
}

// Editors leave an edge of rounding errors where a path closes, and samples of a Bezier segment
// whose points coincide differ by such. Both are parts of the longest edge.
constexpr double negligible_last_edge = 1e-6, negligible_edge = 1e-12;

// Removes points that repeat the previous one, cyclically for a closed curve; returns their number,
// without the last point of a closed curve, whose repetition marks it as closed.
std::size_t leave_out_repetitions(Plane_curve& curve)
{
  std::vector<Eigen::Vector2d> kept;
  const auto count = static_cast<std::size_t>(curve.points.cols());
  const double longest = longest_edge(curve.points);
  for (const auto& p : curve.points.colwise())
    if (kept.empty() || (kept.back() - p).norm() > negligible_edge * longest) kept.emplace_back(p);
  const std::size_t repeated = count - kept.size();
  const double least = negligible_last_edge * longest;
  if (curve.is_closed && kept.size() > 1 && (kept.back() - kept.front()).norm() <= least)
    kept.pop_back();
  curve.points = columns(kept);
  return repeated;
}

}  // namespace

Eigen::Matrix2Xd columns(const std::vector<Eigen::Vector2d>& points)
{
  Eigen::Matrix2Xd result(2, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    result.col(static_cast<Eigen::Index>(i)) = points[i];
  return result;
}

std::optional<Curve_format> curve_format_of(const std::string& path)
{
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (extension == ".svg") return Curve_format::svg;
  if (extension == ".obj") return Curve_format::obj;
  if (extension == ".csv" || extension == ".txt" || extension == ".xy") return Curve_format::csv;
  return {};
}

std::vector<Plane_curve> read_plane_curves(const std::string& path, const Curve_reading& reading,
                                           std::vector<std::string>& notes)
{
  const auto format = curve_format_of(path);
  if (!format)
    throw Read_error(path, 0, "has no known extension, wanted .svg, .obj, .csv, .txt or .xy");
  std::vector<Plane_curve> curves = parse(*format, path, reading, notes);
  if (curves.empty()) throw Read_error(path, 0, "no curves, wanted one at least");
  std::size_t repeated = 0;
  for (Plane_curve& curve : curves) {
    curve.is_closed = reading.are_closed.value_or(looks_closed(curve, *format));
    repeated += leave_out_repetitions(curve);
  }
  if (repeated > 0)
    notes.push_back("left out: " + std::to_string(repeated) +
                    (repeated == 1 ? " point that repeats" : " points that repeat") +
                    " the one before");
  return curves;
}

}  // namespace conformal
