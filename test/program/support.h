// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef TEST_PROGRAM_SUPPORT_H
#define TEST_PROGRAM_SUPPORT_H

#include "conformal/io/file/numbers.h"
#include "support/Temporary_folder.h"

#include <Conformal_geometry_processing/mesh/Mesh_view.h>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
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

class Program : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return m_folder / name; }

  std::string write(const std::string& name, const std::string& text) const
  {
    cgp_test::put_file(path(name), text);
    return path(name);
  }

  /// `arguments` are for the shell, in the folder of the test
  Program_run run(const std::string& arguments) const
  {
    return shell(std::string(CGP_CONFORMAL_PROGRAM) + ' ' + arguments);
  }

  Program_run shell(const std::string& command) const
  {
    const std::string whole =
        "cd '" + m_folder.path().string() + "' && { " + command + "; } >stdout.txt 2>stderr.txt";
    const int status = std::system(whole.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(path("stdout.txt")),
            content(path("stderr.txt"))};
  }

  bool has(const std::string& name) const { return m_folder.has(name); }

  std::size_t temporary_files() const
  {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(m_folder.path()))
      count += entry.path().extension() == ".tmp";
    return count;
  }

 private:
  cgp_test::Temporary_folder m_folder;
};

inline std::string off(const Conformal_geometry_processing::Mesh_view& mesh,
                       const std::string& more_points = "", int size_of_more = 0)
{
  std::string text = "OFF\n" + std::to_string(mesh.size_of_vertices() + size_of_more) + ' ' +
                     std::to_string(mesh.size_of_faces()) + " 0\n" + more_points;
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    for (Eigen::Index i = 0; i < 3; ++i) {
      conformal::append_number(text, mesh.position(v)[i]);
      text += i == 2 ? '\n' : ' ';
    }
  for (const auto& corners : mesh.corners()) {
    text += '3';
    for (const int v : corners) text += ' ' + std::to_string(v + size_of_more);
    text += '\n';
  }
  return text;
}

/// the last line on stderr is the only error, and has the words
inline ::testing::AssertionResult fails(const Program_run& run, int code, const std::string& words)
{
  const std::size_t error = run.err.find("conformal: error: ");
  const bool is_one_line =
      error != std::string::npos && run.err.find('\n', error) + 1 == run.err.size();
  if (run.code == code && is_one_line && run.err.find(words, error) != std::string::npos)
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << "code " << run.code << ", wanted " << code << " and '" << words << "': " << run.err;
}

}  // namespace program_test

#endif
