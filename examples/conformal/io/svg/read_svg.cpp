// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "read_svg.h"

#include "svg_path.h"
#include "svg_transform.h"

#include "conformal/io/file/Xml_scanner.h"
#include "conformal/io/file/numbers.h"

#include <algorithm>
#include <array>
#include <map>

namespace conformal {
namespace {

using namespace std::string_view_literals;

// Elements whose contents are not drawn directly.
constexpr std::array definitions = {"defs"sv,    "clipPath"sv, "mask"sv,
                                    "pattern"sv, "marker"sv,   "symbol"sv};

// Elements that are drawn, but are not supported curves.
constexpr std::array other_shapes = {"rect"sv, "circle"sv, "ellipse"sv, "line"sv,
                                     "text"sv, "image"sv,  "use"sv};

template <class Names>
bool is_one_of(std::string_view name, const Names& names)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

class Svg_reader {
 public:
  Svg_reader(std::string_view bytes, const std::string& path, const Curve_reading& reading)
      : m_scanner(bytes, path), m_reading(reading)
  {
    while (const auto tag = m_scanner.next()) read(*tag);
    if (!m_is_svg) m_scanner.fail("no svg element, wanted an SVG file");
  }

  std::vector<Plane_curve> take() { return std::move(m_curves); }

  std::vector<std::string> notes() const
  {
    std::vector<std::string> notes;
    for (const auto& [name, count] : m_left_out)
      notes.push_back("left out: " + std::to_string(count) + " of the element " + name +
                      ", which is not a path, polygon or polyline");
    return notes;
  }

 private:
  void read(const Xml_tag& tag)
  {
    m_is_svg = m_is_svg || tag.name == "svg";
    if (is_one_of(tag.name, definitions)) m_depth += int{tag.opens} - int{tag.closes};
    if (tag.opens)
      m_maps.push_back(m_maps.back() *
                       parse_svg_transform(tag.attribute("transform").value_or(""), fault()));
    if (tag.opens && m_depth == 0) read_shape(tag);
    if (tag.closes && m_maps.size() > 1) m_maps.pop_back();
  }

  void read_shape(const Xml_tag& tag)
  {
    if (is_one_of(tag.name, other_shapes)) ++m_left_out[std::string(tag.name)];
    if (tag.name == "path")
      add_path(tag);
    else if (tag.name == "polygon" || tag.name == "polyline")
      add_polygon(tag);
  }

  Svg_fault fault() const
  {
    return [this](const std::string& message) { m_scanner.fail(message); };
  }

  void add_path(const Xml_tag& tag)
  {
    const auto parts = parse_svg_path(tag.attribute("d").value_or(""), m_reading.samples, fault());
    for (const Plane_curve& part : parts) add(tag, part);
  }

  void add_polygon(const Xml_tag& tag)
  {
    const auto points = parse_svg_points(tag.attribute("points").value_or(""), fault());
    if (points.empty()) return;
    const bool is_closed = tag.name == "polygon" || points.front() == points.back();
    add(tag, {"", columns(points), is_closed});
  }

  void add(const Xml_tag& tag, Plane_curve curve)
  {
    curve.points = m_maps.back() * curve.points;
    curve.points.row(1) *= -1;  // y is down in SVG
    curve.name = "curve " + std::to_string(m_curves.size()) + " (" + std::string(tag.name) +
                 " in line " + std::to_string(tag.line) + ")";
    m_curves.push_back(std::move(curve));
  }

  Xml_scanner m_scanner;
  const Curve_reading& m_reading;
  std::vector<Plane_curve> m_curves;
  std::map<std::string, int> m_left_out;
  std::vector<Eigen::Affine2d> m_maps = {Eigen::Affine2d::Identity()};  // of the open elements
  int m_depth = 0;
  bool m_is_svg = false;
};

}  // namespace

std::vector<Plane_curve> parse_svg(std::string_view bytes, const std::string& path,
                                   const Curve_reading& reading, std::vector<std::string>& notes)
{
  Svg_reader reader(bytes, path, reading);
  for (const std::string& note : reader.notes()) notes.push_back(note);
  return reader.take();
}

}  // namespace conformal
