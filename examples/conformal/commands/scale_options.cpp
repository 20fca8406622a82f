// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "option_groups.h"

#include "conformal/process/text.h"

#include <Conformal_geometry_processing/spin/Scale_control.h>

#include <cstdlib>

namespace conformal {

CLI::Option* add_max_scale(CLI::App& command, std::optional<double>& bound,
                           const std::string& remark)
{
  const auto read = [&bound](const std::string& text) {
    bound.reset();
    if (text != "none") bound = std::strtod(text.c_str(), nullptr);
  };
  const auto is_bound = [](const std::string& text) {
    char* end = nullptr;
    const double b = std::strtod(text.c_str(), &end);
    const bool is_good = text == "none" || (*end == 0 && b > 1 && finite(text).empty());
    return is_good ? std::string() : "a number above 1, or none, is needed: " + text;
  };
  return command
      .add_option_function<std::string>(
          "--max-scale", read,
          "largest factor by which lengths may grow or shrink, on 98 % of the area, at tips 1.5 "
          "times that; or none" +
              remark)
      ->check(CLI::Validator(is_bound, "FLOAT > 1 or none"))
      ->default_str(bound ? text_of(*bound) : "none");
}

void add_scale_control(CLI::App& command, Scale_options& scales, std::optional<double>& bound)
{
  const double wanted = CGP::internal::default_bound_of_wanted_scales;
  auto* max_scale = add_max_scale(command, bound,
                                  ": rho is applied as it is, whatever collapses; " +
                                      text_of(wanted) + " where sizes are wanted");
  auto* target = command.add_option_group("wanted sizes", "factors of lengths, one of");
  target
      ->add_option("--target-scale-expression", scales.target_expression,
                   "formula: factors by which lengths should change, to which --max-scale is "
                   "relative; with --rho-expression 0, a change of sizes alone")
      ->check(formula);
  target
      ->add_option("--target-scale-property", scales.target_property,
                   "vertex property with these factors")
      ->check(not_empty);
  auto* lock = command.add_option_group("locked sizes", "where sizes have to stay, one of");
  lock->add_option("--lock-expression", scales.lock_expression,
                   "formula: where it is 1, the change of sizes counts 100 times as much as where "
                   "it is 0")
      ->check(formula);
  lock->add_option("--lock-property", scales.lock_property, "vertex property with these numbers")
      ->check(not_empty);
  for (CLI::Option_group* group : {target, lock}) group->require_option(0, 1);
  target->parse_complete_callback([&bound, max_scale, target, wanted] {
    if (max_scale->count() > 0 || target->count_all() == 0) return;
    max_scale->default_str(text_of(wanted));
    bound = wanted;
  });
}

}  // namespace conformal
