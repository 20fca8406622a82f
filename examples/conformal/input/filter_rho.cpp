// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "filter_rho.h"

#include "conformal/process/Failure.h"

#include <Conformal_geometry_processing/flow/Curvature_filter.h>
#include <Conformal_geometry_processing/mesh/requirements.h>

namespace conformal {
namespace {

const double default_radius = 6;  // pixels

CGP::Curvature_band band(Filter_choice choice)
{
  if (choice == Filter_choice::low_pass) return CGP::Curvature_band::low;
  if (choice == Filter_choice::high_pass) return CGP::Curvature_band::high;
  return CGP::Curvature_band::unsharp;
}

bool is_filtered(const Rho_options& options)
{
  return options.filter.choice != Filter_choice::none;
}

void refuse_if(bool is_wrong, const char* message)
{
  if (is_wrong) throw Failure(Exit_code::usage, message);
}

}  // namespace

bool is_filtered_on_surface(const Rho_options& options)
{
  return is_filtered(options) && !options.filter.on_image.value_or(!options.image.empty());
}

void require_possible_filter(const Rho_options& options)
{
  const Filter_request& filter = options.filter;
  const bool on_surface = is_filtered_on_surface(options);
  const bool on_image = is_filtered(options) && !on_surface;
  refuse_if(filter.amount && filter.choice != Filter_choice::unsharp,
            "filter-amount is of --filter unsharp only");
  refuse_if(on_image && options.image.empty(),
            "filter-on=image wants a picture; try: --advanced filter-on=surface");
  refuse_if(on_surface && filter.radius,
            "--filter-radius is of pictures; try: --filter-weight, or --advanced filter-on=image");
  refuse_if(on_image && (filter.weight || filter.order),
            "--filter-weight and filter-order are of filters on the surface; try: "
            "--filter-radius, or --advanced filter-on=surface");
}

CGP::Gray_image filtered(CGP::Gray_image image, const Rho_options& options)
{
  if (!is_filtered(options) || is_filtered_on_surface(options)) return image;
  const Filter_request& filter = options.filter;
  return CGP::filtered(image, band(filter.choice), filter.radius.value_or(default_radius),
                       filter.amount.value_or(1));
}

namespace {

/// `--mollify` takes faces of area zero, the Laplacian of the filter does not.
void require_areas_to_filter(const Surface_input& input)
{
  try {
    CGP::require_positive_areas(input.mesh, "filter");
  } catch (const CGP::Precondition_error&) {
    throw unsuitable(input.file.path,
                     "has faces of area zero, which filters on the surface do not take; try: "
                     "--repair, or no --filter");
  }
}

}  // namespace

CGP::Curvature_potential filtered(const Surface_input& input, const CGP::Curvature_potential& rho,
                                  const Filter_request& filter)
{
  refuse_if(rho.on == CGP::Curvature_potential::On::faces,
            "filter-on=surface wants rho on vertices; try: --on vertices");
  require_areas_to_filter(input);
  CGP::Filter_options options;
  options.weight = filter.weight.value_or(options.weight);
  options.order = filter.order.value_or(options.order);
  options.amount = filter.amount.value_or(options.amount);
  return CGP::Curvature_potential::on_vertices(
      CGP::filtered_on_surface(input.mesh, rho.values, band(filter.choice), options));
}

}  // namespace conformal
