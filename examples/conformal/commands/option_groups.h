// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "option_checks.h"

#include "conformal/input/Boundary_options.h"
#include "conformal/input/Rho_options.h"
#include "conformal/process/Common_options.h"
#include "conformal/transform/Spin_options.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace conformal {

/// an option whose value is one of the words, which are in the order of the enumeration
template <class Choice>
CLI::Option* add_choice(CLI::App& command, const std::string& name, Choice& choice,
                        const std::vector<std::string>& words, const std::string& description)
{
  const auto choose = [&choice, words](const std::string& word) {
    choice = static_cast<Choice>(std::find(words.begin(), words.end(), word) - words.begin());
  };
  return command.add_option_function<std::string>(name, choose, description)
      ->check(CLI::IsMember(words))
      ->default_str(words[static_cast<std::size_t>(choice)]);
}

// What several commands take.

/// what all take
void add_common(CLI::App& command, Common_options& common);

void add_input(CLI::App& command, std::string& input);
void add_repair(CLI::App& command, Common_options& common);
CLI::Option* add_output(CLI::App& command, Common_options& common,
                        const char* what = "where the result goes");

/// likewise for a mesh, with options for PLY
CLI::Option* add_mesh_output(CLI::App& command, Common_options& common,
                             const char* what = "where the result goes");
void add_html(CLI::App& command, Common_options& common);

/// `--each-component`, and whether to go on where one fails
void add_components(CLI::App& command, Common_options& common);

/// of commands that transform a surface: its repair, its components, the output and its page
void add_transformation(CLI::App& command, Common_options& common);

/// `--rho-expression` and the others; the group of which at most one is allowed
CLI::Option_group* add_rho(CLI::App& command, Rho_options& rho);

/// `--filter` and what belongs to it
void add_filter(CLI::App& command, Filter_request& filter);

void add_lambda(CLI::App& command, std::string& lambda);
void add_solver(CLI::App& command, std::string& solver);

/// what happens without `--mollify` where it is tried on its own
inline constexpr const char* tried_otherwise =
    ". Without this option it is done where the result does not verify otherwise; --mollify=0 "
    "never "
    "does it";

/// \param otherwise what happens without this option, as the end of a sentence
void add_mollification(CLI::App& command, std::optional<double>& mollification,
                       const std::string& otherwise = "");
/// \brief `--max-scale`, a number or none
/// \param bound its default
/// \param remark what the description ends with
CLI::Option* add_max_scale(CLI::App& command, std::optional<double>& bound,
                           const std::string& remark = "; apart from the scale of the whole");
/// `--max-scale`, and what it refers to
void add_scale_control(CLI::App& command, Scale_options& scales);
/// where the search for a surface ends
void add_distance_tolerance(CLI::App& command, double& tolerance);
void add_period_defect(CLI::App& command, std::optional<double>& max_period_defect);
void add_boundary(CLI::App& command, Boundary_choice& boundary);
/// \param remark what the descriptions end with
void add_eigenvector(CLI::App& command, Common_options& common, const std::string& remark = "");
/// what a map is judged by
void add_map_limits(CLI::App& command, CGP::Spin_report::Limits& limits, bool& force);

/// what a spin transformation is judged by
void add_limits(CLI::App& command, CGP::Spin_report::Limits& limits, bool& force);

}  // namespace conformal
