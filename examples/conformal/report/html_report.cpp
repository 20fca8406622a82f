// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "html_report.h"

#include "report_page.h"

#include "conformal/io/file/base64.h"
#include "conformal/io/file/little_endian.h"

#include <Conformal_geometry_processing/measure/quasi_conformal_error.h>

#include <cstdint>

namespace conformal {
namespace {

std::string block(const std::string& name, const std::string& type, const std::string& content)
{
  return "<script type=\"" + type + "\" id=\"" + name + "\">" + content + "</script>\n";
}

template <class Number, class Values>
std::string numbers(const std::string& name, const Values& values)
{
  std::string bytes;
  for (const auto value : values) append_little_endian(bytes, static_cast<Number>(value));
  return block(name, "text/plain", base64(bytes));
}

std::string positions(const std::string& name, const CGP::Points& points)
{
  return numbers<float>(name, points.reshaped());
}

std::string faces(const CGP::Mesh_view& mesh)
{
  std::vector<int> corners;
  for (const auto& face : mesh.corners()) corners.insert(corners.end(), face.begin(), face.end());
  return numbers<std::uint32_t>("faces", corners);
}

std::string squares(const Exhibit& exhibit)
{
  std::vector<double> places;
  for (const auto& place : exhibit.squares) places.insert(places.end(), place.begin(), place.end());
  return numbers<float>("squares", places);
}

// As large as a float can be where a face is squashed.
std::string quality(const Exhibit& exhibit)
{
  const double largest = 1e30;
  const Eigen::VectorXd Q = CGP::quasi_conformal_errors(exhibit.before, exhibit.after);
  return numbers<float>("quality", Eigen::VectorXd(Q.cwiseMin(largest)));
}

// In JSON a < is in a string: so escaped it can neither end the block nor begin a comment.
std::string escaped(const std::string& json)
{
  std::string text;
  for (const char c : json)
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  return text;
}

}  // namespace

std::string html_report(const Exhibit& exhibit, const std::string& json)
{
  return report_page_begin + block("report", "application/json", escaped(json)) +
         positions("before", exhibit.before.positions()) + positions("after", exhibit.after) +
         faces(exhibit.before) + quality(exhibit) + squares(exhibit) +
         numbers<float>("rho", exhibit.rho) +
         block("squares-of", "text/plain", exhibit.kind_of_squares) + report_page_end;
}

std::string why_no_html_reports()
{
  return report_page_fault;
}

}  // namespace conformal
