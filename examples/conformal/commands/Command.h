// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/process/Common_options.h"
#include "conformal/report/Session.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace conformal {

/// a file on the command line
struct Named_file {
  enum class Role { read, replaceable, written };  // replaceable: by the result

  std::string name;  ///< for messages
  std::string path;  ///< empty: there is none
  Role role = Role::read;
};

using Files = std::vector<Named_file>;

/// A subcommand: a row of the table of commands. Its options live with it.
struct Command {
  std::string name;
  std::string about;  ///< the text of `--help`, with an example
  std::function<void(CLI::App&, Common_options&)> add_options;
  std::function<Files()> files;  ///< besides those that all commands write
  std::function<void(Session&)> run;
};

/// \param add_options adds the options of the command, and those of all that it takes
/// \param files those that the options name
template <class Options>
Command make_command(std::string name, std::string about,
                     void (*add_options)(CLI::App&, Options&, Common_options&),
                     Files (*files)(const Options&), void (*run)(const Options&, Session&))
{
  const auto options = std::make_shared<Options>();
  return {std::move(name), std::move(about),
          [=](CLI::App& app, Common_options& common) { add_options(app, *options, common); },
          [=] { return files(*options); }, [=](Session& session) { run(*options, session); }};
}

}  // namespace conformal
