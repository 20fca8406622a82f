// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "program/support.h"

#include "conformal/io/file/numbers.h"

#include <sys/wait.h>
#include <nlohmann/json.hpp>

#include <cstdlib>

namespace program_test {

std::string program()
{
  const char* const other = std::getenv("CGP_CONFORMAL_PROGRAM");  // see test/tools/sanitize
  return other ? other : CGP_CONFORMAL_PROGRAM;
}

Program_run Program::run(const std::string& arguments) const
{
  return shell(program() + ' ' + arguments);
}

Program_run Program::shell(const std::string& command) const
{
  const std::string whole =
      "cd '" + m_folder.path().string() + "' && { " + command + "; } >stdout.txt 2>stderr.txt";
  const int status = std::system(whole.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(path("stdout.txt")),
          content(path("stderr.txt"))};
}

nlohmann::json Program::read_json(const std::string& name) const
{
  return nlohmann::json::parse(content(path(name)));
}

std::size_t Program::temporary_files() const
{
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(m_folder.path()))
    count += entry.path().extension() == ".tmp";
  return count;
}

std::string off(const Conformal_geometry_processing::Mesh_view& mesh,
                const std::string& more_points, int size_of_more)
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

::testing::AssertionResult fails(const Program_run& run, int code, const std::string& words)
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
