// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Quaternionic_linear_algebra/vector_units/Vector_unit.h>

#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "Row.h"

namespace cgp_benchmark {

/// the command line of benchmark_solvers
struct Options {
  Job job;
  std::vector<std::string> tables, models, meshes;
  std::vector<std::string> passed_on;  // the words that a row's process gets too
  bool all = false;
  int row = -1;  // the row to be measured by this process
};

/// the parts between the separators
inline std::vector<std::string> split(const std::string& words, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(words);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

/// the kernels of this vector unit from here on
/// \throws std::runtime_error where the machine or the library has none of this name
inline void choose_unit(const std::string& name)
{
  using Unit = CGP::internal::Vector_unit;
  for (const Unit unit : {Unit::baseline, Unit::avx2, Unit::avx512})
    if (name == CGP::to_string(unit) && CGP::set_vector_unit(unit)) return;
  throw std::runtime_error("no vector unit " + name);
}

/// \throws std::exception where a word is not understood
inline Options read_options(int argc, char** argv)
{
  Options options;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const std::size_t equals = word.find('=');
    const std::string key = word.substr(0, equals);
    const std::string value = equals == std::string::npos ? "" : word.substr(equals + 1);
    const bool is_mesh = word.rfind("--", 0) != 0;
    if (is_mesh)
      options.meshes.push_back(word);
    else if (key == "--tables")
      options.tables = split(value, ',');
    else if (key == "--models")
      options.models = split(value, ';');
    else if (key == "--runs")
      options.job.runs = std::stoi(value);
    else if (key == "--seconds")
      options.job.seconds = std::stod(value);
    else if (key == "--amplitude")
      options.job.amplitude = std::stod(value);
    else if (key == "--tolerance")
      options.job.tolerance = std::stod(value);
    else if (key == "--unit")
      choose_unit(value);
    else if (key == "--all")
      options.all = true;
    else if (key == "--row")
      options.row = std::stoi(value);
    else if (key == "--reference")
      options.job.reference = value;
    else
      throw std::runtime_error("unknown option " + word);
    if (!is_mesh) options.passed_on.push_back(word);
  }
  if (options.meshes.empty()) options.meshes = {"20", "41", "81"};
  return options;
}

}  // namespace cgp_benchmark
