// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Rho_options.h"
#include "Surface_input.h"
#include "User_frame.h"

#include <Conformal_geometry_processing/operators/Curvature_potential.h>

#include <string>

namespace conformal {

/// \brief The change of curvature that the user asks for, in 1/length of the *user's frame*, with
/// the amplitude applied, and filtered. Divided by `User_frame::unit()` the library takes it.
/// \throws Failure, Read_error
CGP::Curvature_potential read_rho(const Surface_input& input, const Rho_options& options);

/// \brief Numbers of the vertices from a formula or a property, none if both are empty.
/// \param option whose value the formula is
/// \throws Failure, Read_error
Eigen::VectorXd vertex_numbers(const Surface_input& input, const std::string& option,
                               const std::string& expression, const std::string& property);

/// each of the four sources, without the amplitude and filters on the surface
CGP::Curvature_potential rho_from_expression(const Surface_input& input, const Rho_options&,
                                             const std::string& option = "--rho-expression");
CGP::Curvature_potential rho_from_property(const Surface_input& input, const Rho_options&);
CGP::Curvature_potential rho_from_file(const Surface_input& input, const Rho_options&);
CGP::Curvature_potential rho_from_image(const Surface_input& input, const Rho_options&);

}  // namespace conformal
