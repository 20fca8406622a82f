// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "output_names.h"

#include "conformal/process/Failure.h"

#include <filesystem>
#include <string>
#include <system_error>
#include <variant>
#include <vector>

namespace conformal {
namespace {

struct Named_file {
  std::string name;  // for messages
  std::string path;  // empty: there is none
  bool is_replaceable = false;
};

using Files = std::vector<Named_file>;

Files joined(Files files, const Files& more)
{
  files.insert(files.end(), more.begin(), more.end());
  return files;
}

Files files_of(const Rho_options& rho)
{
  return {{"--rho-file", rho.file}, {"--paint", rho.image}};
}

Files files_of(const Prescription_options& boundary)
{
  return {{"--tangents-from", boundary.tangents_from},
          {"--binormals-from", boundary.binormals_from},
          {"--positions-from", boundary.positions_from},
          {"--curve", boundary.curve}};
}

/// The files that a command reads.
struct Inputs {
  Files operator()(std::monostate) const { return {}; }
  Files operator()(const Sphere_options&) const { return {}; }

  template <class Options>  // the others
  Files operator()(const Options& options) const
  {
    return {{"the input", options.input, true}};
  }

  Files operator()(const Spin_options& spin) const
  {
    return joined({{"the input", spin.input, true}}, files_of(spin.rho));
  }

  Files operator()(const Boundary_options& boundary) const
  {
    return joined((*this)(boundary.spin), files_of(boundary.prescription));
  }

  Files operator()(const Fit_options& fit) const
  {
    return joined((*this)(fit.spin), {{"the target", fit.target}});
  }

  Files operator()(const Blend_options& blend) const
  {
    const bool begins_with_a = blend.onto.empty();
    return {{"the mesh A", blend.spin.input, begins_with_a},
            {"the mesh B", blend.other},
            {"--onto", blend.onto, true}};
  }

  Files operator()(const Compare_options& compare) const
  {
    return {{"the mesh before", compare.before}, {"the mesh after", compare.after, true}};
  }
};

Files outputs_of(const Command_line& line)
{
  Files files = {
      {"--output", line.common.output}, {"--json", line.common.json}, {"--html", line.common.html}};
  if (const auto* spectrum = std::get_if<Spectrum_options>(&line.options))
    files.push_back({"--csv", spectrum->csv});
  return files;
}

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
  const Files outputs = outputs_of(line);
  Files inputs = std::visit(Inputs(), line.options);
  for (Named_file& input : inputs)
    if (input.path == "-") input.path = "/dev/stdin";
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const bool is_result = i == 0;
    for (const Named_file& input : inputs)
      if (!is_result || !input.is_replaceable) require_different(outputs[i], input);
    for (std::size_t j = 0; j < i; ++j) require_different(outputs[i], outputs[j]);
  }
}

}  // namespace conformal
