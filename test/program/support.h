// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "support/Temporary_folder.h"

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <gtest/gtest.h>
#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

/// Runs the program as a user does, in a temporary folder.
namespace program_test {

using cgp_test::content;

/// Exit code and output of a run
struct Program_run {
  int code;
  std::string out, err;
};

/// the file that is tested
std::string program();

class Program : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return m_folder / name; }

  std::string write(const std::string& name, const std::string& text) const
  {
    cgp_test::put_file(path(name), text);
    return path(name);
  }

  /// `arguments` are for the shell, in the folder of the test
  Program_run run(const std::string& arguments) const;

  Program_run shell(const std::string& command) const;

  nlohmann::json read_json(const std::string& name) const;

  bool has(const std::string& name) const { return m_folder.has(name); }

  std::size_t temporary_files() const;

 private:
  cgp_test::Temporary_folder m_folder;
};

std::string off(const Conformal_geometry_processing::Mesh_view& mesh,
                const std::string& more_points = "", int size_of_more = 0);

/// the last line on stderr is the only error, and has the words
::testing::AssertionResult fails(const Program_run& run, int code, const std::string& words);

}  // namespace program_test
