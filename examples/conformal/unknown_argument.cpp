// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "unknown_argument.h"

#include "conformal/commands/keyed_options.h"
#include "conformal/process/near_names.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <vector>

namespace conformal {
namespace {

bool is_option(const std::string& argument)
{
  return argument.size() > 1 && argument[0] == '-' && argument != "--";
}

const auto all_apps = [](const CLI::App*) { return true; };

/// of all options, without hyphens; a group of options has no name, a command has one
std::vector<std::string> own_names(const CLI::App& command)
{
  std::vector<std::string> names;
  const auto add_all = [&names](const CLI::App& app) {
    for (const CLI::Option* option : app.get_options())
      for (const std::string& name : option->get_lnames())  // each group has --help
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  add_all(command);
  for (const CLI::App* group : command.get_subcommands(all_apps))
    if (group->get_name().empty() && !group->get_disabled()) add_all(*group);
  return names;
}

/// `--rho=x` and `-rho` are about rho
std::string bare_name(const std::string& option)
{
  const std::size_t begin = option.find_first_not_of('-');
  return begin == std::string::npos ? "" : option.substr(begin, option.find('=') - begin);
}

/// the commands that have an option
std::string owners(const CLI::App& app, const std::string& name)
{
  std::vector<std::string> found;
  for (const CLI::App* command : app.get_subcommands(all_apps)) {
    const std::vector<std::string> names = own_names(*command);
    if (std::find(names.begin(), names.end(), name) != names.end())
      found.push_back(command->get_name());
  }
  return listed(found);
}

std::string fault_of_option(const CLI::App& app, const std::string& option)
{
  const std::string shown = option.substr(0, option.find('=')), name = bare_name(option);
  const std::string all = owners(app, name);
  const std::vector<std::string> early = app.remaining(false);
  const bool is_early = std::find(early.begin(), early.end(), option) != early.end();
  const CLI::App& command = is_early ? app : *app.get_subcommands().front();
  if (const std::string keyed = keyed_option(command, name); !keyed.empty())
    return "unknown option " + shown + "; try: " + keyed;
  std::vector<std::string> near = near_names(name, own_names(command));
  if (is_early && near.empty() && !app.get_subcommands().empty())
    return "the option " + shown + " is before the name of a command; try: " + help_command(app);
  for (std::string& other : near) other.insert(0, "--");
  return "unknown option " + shown + (all.empty() ? "" : ", which is one of " + all) +
         "; try: " + (near.empty() ? "" : listed(near) + ", or ") + help_command(app);
}

}  // namespace

// In `--wrong 3 input`, where 3 was parsed as the input, the option is the error.
std::string fault_of_unknown_argument(const CLI::App& app)
{
  const std::vector<std::string> all = app.remaining(true);
  const auto option = std::find_if(all.begin(), all.end(), is_option);
  if (option != all.end()) return fault_of_option(app, *option);
  if (all.empty()) return "";
  return "unexpected argument '" + all.front() +
         "'; try: quotes around values with blanks or *, or " + help_command(app);
}

std::string help_command(const CLI::App& app)
{
  const std::vector<CLI::App*> commands = app.get_subcommands();
  return "conformal " + (commands.empty() ? "" : commands.front()->get_name() + " ") + "--help";
}

}  // namespace conformal
