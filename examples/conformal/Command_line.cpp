// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Command_line.h"

#include "unknown_argument.h"

#include "conformal/commands/commands.h"
#include "conformal/commands/option_checks.h"
#include "conformal/commands/option_groups.h"
#include "conformal/process/Failure.h"
#include "conformal/process/near_names.h"
#include "conformal/process/versions.h"

#include <CLI/CLI.hpp>

namespace conformal {
namespace {

const char* const about =
    "Edits, compares and describes surfaces by their curvature, without shearing them.\n"
    "Reads and writes PLY, OFF, OBJ, glTF, GLB, VTK and STL, writes USD; by the extension of the "
    "output.\n"
    "Vertices and faces keep their order and their properties; numbers in messages count from 0.\n"
    "Example: conformal spin bear.off --rho-expression '1.5*sin(5*y)' -o bear_spin.ply\n"
    "Exit codes: 0 done, 1 failed or not verified, 2 usage, 3 cannot read, 4 input unsuitable,\n"
    "5 cannot write, 6 out of memory, 130 interrupted, 143 terminated. Where the reader of "
    "standard\n"
    "output ends early, as head does, the rest is dropped, and the exit code is that of the work.";

Report::Value value_of(const CLI::Option& option)
{
  const std::vector<std::string>& words = option.results();
  const bool is_flag = option.get_expected_max() == 0;
  if (is_flag && (words.empty() || words.front() == "true")) return !words.empty();
  std::string text = words.empty() ? option.get_default_str() : "";
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

/// Reports the options in force, as they were given or by default; those without a value are none.
void report_options(const CLI::App& app, Report& report)
{
  for (const CLI::Option* option : app.get_options()) {
    const Report::Value value = value_of(*option);
    const bool is_help = option->get_single_name() == "help";
    if (!is_help && value != Report::Value(std::string()))
      report.set("options/" + option->get_single_name(), value);
  }
  for (const CLI::App* group : app.get_subcommands([](const CLI::App*) { return true; }))
    report_options(*group, report);
}

/// No number of any option may be infinite, too large, or none.
void require_finite_numbers(CLI::App& app)
{
  for (CLI::Option* option : app.get_options())
    if (option->get_type_name().find("FLOAT") == 0) option->check(finite);
  for (CLI::App* group : app.get_subcommands([](CLI::App*) { return true; }))
    require_finite_numbers(*group);
}

/// Names the commands that this program was built without; empty where it has all.
std::string about_other_commands()
{
  std::string names;
  for (const std::string& name : commands_not_built()) names += (names.empty() ? "" : ", ") + name;
  return names.empty() ? "" : "Built without " + names + "; to build them:\n" + how_to_build_all;
}

class Parser {
 public:
  Parser() : m_app(about, "conformal"), m_commands(commands())
  {
    m_app.require_subcommand(1);
    m_app.set_version_flag("--version", versions);
    for (const Command& command : m_commands) {
      CLI::App& app = *m_app.add_subcommand(command.name, command.about);
      add_common(app, m_common);
      command.add_options(app, m_common);
      require_finite_numbers(app);
    }
    m_app.footer(about_other_commands());  // commands would inherit it
  }

  Command_line parse(int argc, const char* const* argv)
  {
    if (argc > 1) require_command(argv[1]);
    try {
      m_app.parse(argc, argv);
    } catch (const CLI::CallForVersion& answer) {
      return answered(answer.what());
    } catch (const CLI::CallForHelp&) {
      return answered(m_app.help());
    } catch (const CLI::ParseError& error) {
      // Without an option that is unknown, another one may seem to be missing.
      const std::string fault = fault_of_unknown_argument(m_app);
      throw Failure(
          Exit_code::usage,
          !fault.empty() ? fault : error.what() + std::string("; try: ") + help_command(m_app));
    }
    return chosen();
  }

 private:
  const Command* find(const std::string& name) const
  {
    for (const Command& command : m_commands)
      if (command.name == name) return &command;
    return nullptr;
  }

  void require_command(const std::string& name) const
  {
    if (name.empty() || name[0] == '-' || find(name) != nullptr) return;
    require_that_it_was_built(name);
    std::vector<std::string> all;
    for (const Command& command : m_commands) all.push_back(command.name);
    const std::vector<std::string> others = commands_not_built();
    all.insert(all.end(), others.begin(), others.end());
    const std::vector<std::string> near = near_names(name, all);
    throw Failure(Exit_code::usage, "unknown command '" + name + "'; try: " +
                                        listed(near.empty() ? all : near) + ", or --help");
  }

  static void require_that_it_was_built(const std::string& name)
  {
    for (const std::string& other : commands_not_built())
      if (other == name)
        throw Failure(Exit_code::usage,
                      "this program was built without '" + name + "'; try: " + how_to_build_all);
  }

  static Command_line answered(std::string answer)
  {
    Command_line line;
    line.answer = std::move(answer);
    if (line.answer.empty() || line.answer.back() != '\n') line.answer += '\n';
    return line;
  }

  Command_line chosen() const
  {
    const CLI::App& app = *m_app.get_subcommands().front();
    Command_line line{m_common, *find(app.get_name()), {}, {}};
    report_options(app, line.options);
    return line;
  }

  Common_options m_common;
  CLI::App m_app;
  std::vector<Command> m_commands;
};

}  // namespace

Command_line parse_command_line(int argc, const char* const* argv)
{
  return Parser().parse(argc, argv);
}

}  // namespace conformal
