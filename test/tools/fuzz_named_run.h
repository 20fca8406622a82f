// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/io/read_plane_curves.h"
#include "conformal/io/read_surface.h"
#include "conformal/run.h"
#include "fuzz_runs_seeds.h"
#include "fuzz_scratch.h"
#include "fuzz_trials.h"

#include <cmath>
#include <nlohmann/json.hpp>

// One run of the program on one file, in this process, and the laws of its end.

namespace fuzz {

/// what may become of a run; anything else ends the process
enum Fate : std::size_t { verified, not_verified, unsuitable, unreadable };

inline const std::vector<std::string>& fates()
{
  static const std::vector<std::string> names = {"verified", "not verified", "unsuitable",
                                                 "cannot read"};
  return names;
}

/// the words between the program and the file
using Command = std::vector<std::string>;

/// the word for a surface that nothing is wrong with
constexpr const char* whole_surface = "whole.off";

inline const std::vector<Command>& commands()
{
  static const std::vector<Command> all = {
      {"info"},
      {"info", "--repair"},
      {"spin", "--rho-expression", "0.7*sin(4*y)"},
      {"spin", "--rho-expression", "0.7*sin(4*y)", "--repair"},
      {"spin", "--rho-expression", "x", "--on", "faces", "--advanced", "solver=cholmod"},
      {"spin", "--rho-expression", "0.3*x", "--boundary", "tangents"},
      {"flow", "--steps", "2"},
      {"flow", "--steps", "2", "--repair"},
      {"flow", "--steps", "2", "--balance", "initial"},
      {"boundary", "--binormal-tilt", "10*cos(2*pi*s)"},
      {"boundary", "--tangent-rotation", "5*sin(2*pi*s)"},
      {"flatten"},
      {"flatten", "--repair"},
      {"flatten", "--planar"},
      {"harmonic"},
      {"harmonic", "--repair"},
      {"spectrum", "--count", "3"},
      {"compare", whole_surface},
  };
  return all;
}

/// those that read something else than a surface last
inline std::vector<Command> commands_for(const std::string& extension)
{
  if (extension == ".json") return {{"deform", whole_surface, "--targets"}};
  if (extension == ".svg" || extension == ".csv") return {{"curve", "--steps", "3"}};
  return commands();
}

inline std::string text_of(const Command& command)
{
  std::string text = "conformal";
  for (const std::string& word : command)
    text += word.find_first_of(" *()") == std::string::npos ? ' ' + word : " '" + word + "'";
  return text;
}

inline bool has_output(const Command& command)
{
  return command.front() != "info" && command.front() != "spectrum" && command.front() != "compare";
}

inline int exit_code(const Scratch& scratch, const Command& command, const std::string& input,
                     const std::string& output)
{
  std::vector<std::string> words = {"conformal"};
  for (const std::string& word : command)
    words.push_back(word == whole_surface ? scratch.path(word) : word);
  words.insert(words.end(),
               {scratch.path(input), "--quiet", "--json", scratch.path("report.json")});
  if (has_output(command)) words.insert(words.end(), {"-o", scratch.path(output)});
  std::vector<const char*> arguments;
  for (const std::string& word : words) arguments.push_back(word.c_str());
  return conformal::run(static_cast<int>(arguments.size()), arguments.data());
}

// One line that a user understands: nothing of the libraries inside.
inline void require_reason(const std::string& message)
{
  const std::string begin = "conformal: error: ";
  require(message.rfind(begin, 0) == 0 && message.size() > begin.size() + 10,
          "no reason: " + message);
  require(message.find('\n') == message.size() - 1, "not one line: " + message);
  for (const char* inside : {"::", "basic_string", "json.", "what()"})
    require(message.find(inside) == std::string::npos, "no reason for a user: " + message);
}

inline bool is_certified(const std::string& command, const nlohmann::json& report)
{
  const auto& result = report.at("result");
  if (command == "info") return result.contains("problems");
  if (command == "spectrum") return result.contains("eigenvalues");
  if (command == "compare") return result.contains("quasi_conformal");
  if (command != "harmonic") return report.value("verified", false);
  for (const char* name : {"closed_residual", "coclosed_residual", "orthonormal_residual"})
    if (!(result.at(name).get<double>() < 1e-6)) return false;
  return true;
}

inline void require_output(const std::string& path, const nlohmann::json& input)
{
  if (input.contains("curves")) {
    std::vector<std::string> notes;
    const auto curves = conformal::read_plane_curves(path, {}, notes);
    require(curves.size() == input.at("curves").get<std::size_t>(), "output: other curves");
    return;
  }
  const conformal::Surface_file file = conformal::read_surface(path);
  require(file.points.size() == input.at("vertices").get<std::size_t>(), "output: other vertices");
  require(file.polygons.size() == input.at("faces").get<std::size_t>(), "output: other faces");
  for (const auto& point : file.points)
    for (const double x : point) require(std::isfinite(x), "output: a coordinate is not finite");
}

inline void require_success(const Scratch& scratch, const Command& command,
                            const std::string& output)
{
  const auto report = nlohmann::json::parse(scratch.content("report.json"));
  require(is_certified(command.front(), report), "a result without a certificate");
  require(scratch.messages().empty(), "not quiet: " + scratch.messages());
  if (has_output(command))
    require_output(scratch.path(output), report.at("input"));
  else
    require(!scratch.has(output), "an output that nobody asked for");
}

/// A failure has no output. Only a flow that ends early leaves its last complete step, and tells
/// so.
inline void require_failure(const Scratch& scratch, const Command& command,
                            const std::string& output)
{
  require_reason(scratch.messages());
  const bool is_told = scratch.messages().find("the surface after the last") != std::string::npos;
  require(scratch.has(output) == is_told, "an output of a failure");
  if (!is_told) return;
  require(command.front() == "flow", "an output of a failure");
  const auto report = nlohmann::json::parse(scratch.content("report.json"));
  require_output(scratch.path(output), report.at("input"));
}

/// \brief Runs the command on a file with this content and extension.
///
/// A success has a certificate, and an output that can be read and is finite; a failure has a
/// reason of one line, and leaves no output but the last complete step of a flow. Neither leaves a
/// temporary file.
inline Fate fate(const Command& command, const std::string& content, const std::string& extension)
{
  static Scratch scratch;
  static const std::string whole = seed_file(seed_surfaces()[0], ".off", true);
  const bool is_kept = extension == ".off" || extension == ".svg" || extension == ".csv";
  const std::string input = "input" + extension, output = "output" + (is_kept ? extension : ".ply");
  scratch.clear();
  scratch.write(whole_surface, whole);
  scratch.write(input, content);
  scratch.begin_listening();
  const int code = exit_code(scratch, command, input, output);
  scratch.end_listening();
  require(scratch.has_only({whole_surface, input, output, "report.json"}), "a file is left");
  if (code == 0) {
    require_success(scratch, command, output);
    return verified;
  }
  require_failure(scratch, command, output);
  require(code == 1 || code == 3 || code == 4,
          "exit code " + std::to_string(code) + ": " + scratch.messages());
  return code == 1 ? not_verified : code == 3 ? unreadable : unsuitable;
}

}  // namespace fuzz
