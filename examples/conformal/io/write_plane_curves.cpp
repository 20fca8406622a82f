// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "write_plane_curves.h"

#include "read_plane_curves.h"

#include "conformal/io/file/Temporary_file.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/numbers.h"

#include <array>
#include <charconv>
#include <limits>

namespace conformal {
namespace {

void append_short(std::string& text, double value)
{
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::general, 6)
                       .ptr;
  text.append(buffer.data(), end);
}

/// the corners of the rectangle around all curves of all frames, with a margin, in SVG's
/// coordinates
struct View {
  Eigen::Vector2d low, size;

  explicit View(const std::vector<Curve_picture>& frames)
  {
    const double infinity = std::numeric_limits<double>::infinity();
    low.setConstant(infinity);
    Eigen::Vector2d high = -low;
    for (const Curve_picture& frame : frames)
      for (const Plane_curve& curve : frame) {
        low = low.cwiseMin(curve.points.rowwise().minCoeff());
        high = high.cwiseMax(curve.points.rowwise().maxCoeff());
      }
    const double margin = 0.05 * (high - low).maxCoeff();
    size = (high - low).array() + 2 * margin;
    low = Eigen::Vector2d(low.x() - margin, -high.y() - margin);
  }
};

template <class Append>
std::string svg_points(const Plane_curve& curve, Append append)
{
  std::string text;
  for (const auto& p : curve.points.colwise()) {
    if (!text.empty()) text += ' ';
    append(text, p.x());
    text += ',';
    append(text, p.y() == 0 ? 0 : -p.y());  // y is down in SVG
  }
  return text;
}

std::string animation(const std::vector<Curve_picture>& frames, std::size_t c, double seconds)
{
  std::string text = "<animate attributeName=\"points\" dur=\"";
  append_short(text, seconds);
  text += "s\" repeatCount=\"indefinite\" values=\"";
  for (const Curve_picture& frame : frames) {
    if (&frame != &frames.front()) text += ";\n";
    text += svg_points(frame[c], append_short);
  }
  return text + "\"/>";
}

std::string svg(const std::vector<Curve_picture>& frames, double seconds)
{
  const View view(frames);
  std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"";
  for (const double number : {view.low.x(), view.low.y(), view.size.x(), view.size.y()}) {
    if (text.back() != '"') text += ' ';
    append_short(text, number);
  }
  text += "\">\n<g fill=\"none\" stroke=\"#1f4e79\" stroke-linejoin=\"round\" stroke-width=\"";
  append_short(text, 0.006 * view.size.maxCoeff());
  text += "\">\n";
  const Curve_picture& last = frames.back();
  for (std::size_t c = 0; c < last.size(); ++c) {
    const std::string name = last[c].is_closed ? "polygon" : "polyline";
    const auto append_exact = [](std::string& t, double x) { append_number(t, x); };
    text += "<" + name + " points=\"" + svg_points(last[c], append_exact) + "\"";
    text += frames.size() < 2 ? "/>\n" : ">" + animation(frames, c, seconds) + "</" + name + ">\n";
  }
  return text + "</g>\n</svg>\n";
}

std::string csv(const std::vector<Plane_curve>& curves)
{
  std::string text;
  for (const Plane_curve& curve : curves) {
    if (!text.empty()) text += '\n';
    const Eigen::Index m = curve.points.cols();
    for (Eigen::Index i = 0; i < m + int{curve.is_closed}; ++i) {
      append_number(text, curve.points(0, i % m));
      append_number(text += ',', curve.points(1, i % m));
      text += '\n';
    }
  }
  return text;
}

std::string obj(const std::vector<Plane_curve>& curves)
{
  std::string text, lines;
  std::int64_t first = 1;
  for (const Plane_curve& curve : curves) {
    lines += 'l';
    for (const auto& p : curve.points.colwise()) {
      append_number(text += "v ", p.x());
      append_number(text += ' ', p.y());
      text += " 0\n";
    }
    const std::int64_t m = curve.points.cols();
    for (std::int64_t i = 0; i < m; ++i) append_number(lines += ' ', first + i);
    if (curve.is_closed) append_number(lines += ' ', first);
    lines += '\n';
    first += m;
  }
  return text + lines;
}

}  // namespace

void require_curve_format(const std::string& path)
{
  if (!curve_format_of(path))
    throw Write_error(path, "has no known extension, wanted .svg, .csv, .txt, .xy or .obj");
}

void write_plane_curves(const std::string& path, const std::vector<Plane_curve>& curves)
{
  require_curve_format(path);
  switch (*curve_format_of(path)) {
    case Curve_format::svg:
      return write_file(path, svg({curves}, 0));
    case Curve_format::obj:
      return write_file(path, obj(curves));
    default:
      return write_file(path, csv(curves));
  }
}

void write_animation(const std::string& path, const std::vector<Curve_picture>& frames,
                     double seconds)
{
  write_file(path, svg(frames, seconds));
}

}  // namespace conformal
