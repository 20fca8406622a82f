// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace conformal {

enum class Projection { uv, x, y, z, sphere };

enum class Filter_choice { none, low_pass, high_pass, unsharp };

/// Filter for rho; missing values have defaults
struct Filter_request {
  Filter_choice choice = Filter_choice::none;
  std::optional<bool> on_image;  ///< else on the surface; undecided: where there is one
  std::optional<double> radius;  ///< in pixels, on the image
  std::optional<double> weight;  ///< on the surface, as for `CGP::internal::Curvature_filter`
  std::optional<int> order;      ///< likewise
  std::optional<double> amount;  ///< of the unsharp mask
};

/// where rho comes from: exactly one of the four is not empty
struct Rho_options {
  std::string expression, property, file, image;
  Projection projection = Projection::uv;
  double amplitude = 1;
  std::optional<bool> on_faces;  ///< undecided: vertices, or whatever the data fit
  Filter_request filter;
};

}  // namespace conformal
