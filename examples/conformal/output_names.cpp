// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "output_names.h"

#include "conformal/process/Failure.h"

#include <filesystem>
#include <system_error>

namespace conformal {
namespace {

using Role = Named_file::Role;

// Devices and pipes are not destroyed. What does not exist yet has only its name.
bool is_same_file(const std::string& a, const std::string& b)
{
  if (a.empty() || b.empty()) return false;
  std::error_code ignored;
  if (std::filesystem::exists(a, ignored))
    return std::filesystem::is_regular_file(a, ignored) &&
           std::filesystem::equivalent(a, b, ignored);
  const auto place = [&](const std::string& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, ignored), ignored);
  };
  return place(a) == place(b);
}

void require_different(const Named_file& output, const Named_file& other)
{
  if (is_same_file(output.path, other.path))
    throw Failure(Exit_code::usage, output.name + " and " + other.name + " name the same file, " +
                                        output.path + "; try: another name for the output");
}

}  // namespace

void require_separate_outputs(const Command_line& line)
{
  const Common_options& common = line.common;
  const Named_file result{"--output", common.output, Role::written};
  Files inputs, outputs = {result, {"--json", common.json}, {"--html", common.html}};
  for (Named_file& file : line.command->files()) {
    if (file.path == "-") file.path = "/dev/stdin";
    (file.role == Role::written ? outputs : inputs).push_back(file);
  }
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (const Named_file& input : inputs)
      if (i > 0 || input.role != Role::replaceable) require_different(outputs[i], input);
    for (std::size_t j = 0; j < i; ++j) require_different(outputs[i], outputs[j]);
  }
}

}  // namespace conformal
