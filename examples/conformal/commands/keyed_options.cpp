// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "keyed_options.h"

#include "conformal/process/Failure.h"
#include "conformal/process/near_names.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <vector>

namespace conformal {
namespace {

bool is_keyed(const CLI::App* group)
{
  return group->get_disabled();
}

/// Whether a limit was an option of that name, as closure was max-closure.
bool was_named(std::string name, const std::string& limit)
{
  std::replace(name.begin(), name.end(), '-', '_');
  const std::string prefix = name.substr(0, 4);
  return name.size() > 4 && (prefix == "max_" || prefix == "min_") &&
         limit.compare(0, name.size() - 4, name, 4, std::string::npos) == 0;
}

std::vector<std::string> keys(const CLI::App& group)
{
  std::vector<std::string> names;
  for (const CLI::Option* option : group.get_options()) names.push_back(option->get_lnames()[0]);
  return names;
}

std::string list(const CLI::App& group)
{
  const CLI::Formatter formatter;
  std::string text = "of " + group.get_description() + ", with their defaults:\n";
  for (const CLI::Option* option : group.get_options())
    text += formatter.make_option(option, false).replace(2, 2, "  ");  // without --
  return text;
}

/// Sets the options of a group; their own checks find wrong values.
void read(CLI::App& group, const std::vector<std::string>& words)
{
  std::vector<std::string> arguments;
  for (const std::string& word : words) {
    if (word == "help") throw CLI::CallForVersion(list(group), 0);
    const std::string key = word.substr(0, word.find('='));
    if (group.get_option_no_throw("--" + key) == nullptr) {
      const std::vector<std::string> near = near_names(key, keys(group));
      throw Failure(Exit_code::usage,
                    group.get_description() + ": unknown key '" + key +
                        "'; try: " + (near.empty() ? "" : listed(near) + ", or ") +
                        group.get_description() + " help");
    }
    arguments.push_back("--" + word);
  }
  group.parse(std::move(arguments));
}

CLI::App& keyed(CLI::App& command, const std::string& name, const std::string& type,
                const std::string& what)
{
  for (CLI::App* group : command.get_subcommands(is_keyed))
    if (group->get_description() == name) return *group;
  CLI::App& group = *command.add_option_group("", name)->disabled();
  group.set_help_flag();
  const auto set = [&group](const std::vector<std::string>& words) { read(group, words); };
  command.add_option_function<std::vector<std::string>>(name, set, what + "; help lists them")
      ->type_name(type)
      ->allow_extra_args(false);
  return group;
}

}  // namespace

CLI::App& advanced(CLI::App& command)
{
  return keyed(command, "--advanced", "KEY=VALUE", "what is seldom set, any number of times");
}

CLI::App& limit(CLI::App& command)
{
  return keyed(command, "--limit", "NAME=VALUE",
               "what the result is judged by, any number of times");
}

std::string keyed_option(const CLI::App& command, const std::string& name)
{
  for (const CLI::App* group : command.get_subcommands(is_keyed))
    for (const CLI::Option* option : group->get_options())
      if (const std::string key = option->get_lnames()[0]; key == name || was_named(name, key))
        return group->get_description() + " " + key +
               (option->get_expected_max() == 0 ? "" : "=VALUE");
  return "";
}

}  // namespace conformal
