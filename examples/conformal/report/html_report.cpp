// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "html_report.h"

#include "page_blocks.h"
#include "report_page.h"

#include <Conformal_geometry_processing/measure/distortion.h>

#include <vector>

namespace conformal {
namespace {

std::string positions(const std::string& name, const CGP::Points& points)
{
  return numbers_block<float>(name, points.reshaped());
}

std::string squares(const Exhibit& exhibit)
{
  std::vector<double> places;
  for (const auto& place : exhibit.squares) places.insert(places.end(), place.begin(), place.end());
  return numbers_block<float>("squares", places);
}

// As large as a float can be where a face is squashed.
std::string quality(const Exhibit& exhibit)
{
  const double largest = 1e30;
  const Eigen::VectorXd Q = CGP::quasi_conformal_errors(exhibit.before, exhibit.after);
  return numbers_block<float>("quality", Eigen::VectorXd(Q.cwiseMin(largest)));
}

}  // namespace

std::string html_report(const Exhibit& exhibit, const std::string& json)
{
  return report_page_begin + json_block("report", json) +
         positions("before", exhibit.before.positions()) + positions("after", exhibit.after) +
         faces_block("faces", exhibit.before) + quality(exhibit) + squares(exhibit) +
         numbers_block<float>("rho", exhibit.rho) +
         page_block("squares-of", "text/plain", exhibit.kind_of_squares) + report_page_end;
}

std::string why_no_html_reports()
{
  const std::string fault = report_page_fault;
  return fault.empty() ? fault : fault + "; try: " + report_page_advice;
}

}  // namespace conformal
