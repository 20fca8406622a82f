// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "keyed_options.h"
#include "option_checks.h"

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
void add_solver(CLI::App& command, CGP::Spin_solvers& solvers);

/// what happens without `--mollify` where it is tried on its own
inline constexpr const char* tried_otherwise =
    ". Without this option it is done where the result does not verify otherwise; --mollify=0 "
    "never "
    "does it";

/// \brief `--mollify`, where 0 stands for none
/// \param otherwise what happens without this option, as the end of a sentence
CLI::Option* add_mollification(CLI::App& command, std::optional<double>& mollification,
                               const std::string& otherwise = "");
/// \brief `--max-scale`, a number or none
/// \param bound its default
/// \param remark what the description ends with
CLI::Option* add_max_scale(CLI::App& command, std::optional<double>& bound,
                           const std::string& remark = "; apart from the scale of the whole");
/// `--max-scale`, and what it refers to
void add_scale_control(CLI::App& command, Scale_options& scales, std::optional<double>& bound);
/// where the search for a surface ends
void add_distance_tolerance(CLI::App& command, double& tolerance);
void add_period_defect(CLI::App& command, std::optional<double>& max_period_defect);
void add_boundary(CLI::App& command, CGP::Boundary_condition& boundary);
/// \param remark what the descriptions end with
/// \tparam Options has random_seed and tolerance
template <class Options>
void add_eigenvector(CLI::App& command, Options& options, const std::string& remark = "")
{
  advanced(command)
      .add_option("--seed", options.random_seed, "of random start vectors" + remark)
      ->capture_default_str();
  advanced(command)
      .add_option("--tolerance", options.tolerance, "of the eigenvector" + remark)
      ->check(between_zero_and_one)
      ->capture_default_str();
}

/// what a map is judged by
void add_map_limits(CLI::App& command, CGP::Spin_report::Limits& limits, bool& force);

/// what a spin transformation is judged by
void add_limits(CLI::App& command, CGP::Spin_report::Limits& limits, bool& force);

}  // namespace conformal
