// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Command.h"
#include "numbered_outputs.h"
#include "option_groups.h"

#include "conformal/input/Surface_input.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/io/file/snapshot_path.h"
#include "conformal/process/Failure.h"
#include "conformal/repair/select_faces.h"
#include "conformal/report/report_input.h"
#include "conformal/transform/write_result.h"

#include <Conformal_geometry_processing/mesh/topology.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace conformal {
namespace {

const char* const split_about =
    "Writes each component of a mesh to a file of its own: OUTPUT with the number of the "
    "component,\n"
    "in the order of their first vertices (parts_0000.ply). Vertices and faces keep their order "
    "and\n"
    "their properties. The mesh may have any defects. JSON has the numbers before of the vertices "
    "of\n"
    "all files, one after the other (vertex_before_split), and how many each has (vertices).\n"
    "Example: conformal split scan.ply --min-faces 100 -o parts.ply";

struct Split_options {
  std::string input;
  int min_faces = 1;  ///< smaller components are left out
};

void add_options(CLI::App& command, Split_options& split, Common_options& common)
{
  add_input(command, split.input);
  add_repair(command, common);
  add_mesh_output(command, common, "the name to which numbers are added")->required();
  command.add_option("--min-faces", split.min_faces, "leave out components with fewer faces")
      ->check(above_zero)
      ->capture_default_str();
}

Files files(const Split_options& split)
{
  return {{"the input", split.input}};
}

/// the faces in the file of each component that is large enough
std::vector<std::vector<int>> faces_of_components(const Surface_input& input, int min_faces)
{
  const std::vector<int> component = CGP::connected_components(input.mesh);
  std::vector<std::vector<int>> faces;
  for (int t = 0; t < input.mesh.size_of_faces(); ++t) {
    const int v = input.mesh.corners(t)[0];
    const auto c = static_cast<std::size_t>(component[static_cast<std::size_t>(v)]);
    if (faces.size() <= c) faces.resize(c + 1);
    const int f = input.face_in_file[static_cast<std::size_t>(t)];
    if (faces[c].empty() || faces[c].back() != f) faces[c].push_back(f);
  }
  const auto is_small = [&](const auto& own) { return static_cast<int>(own.size()) < min_faces; };
  faces.erase(std::remove_if(faces.begin(), faces.end(), is_small), faces.end());
  return faces;
}

/// \returns the paths of the files
std::vector<std::string> write_parts(const Surface_input& input,
                                     const std::vector<std::vector<int>>& faces, Session& session)
{
  Grid grid({"component", "vertices", "faces", "file"});
  std::vector<std::string> paths;
  try {
    for (std::size_t c = 0; c < faces.size(); ++c) {
      const Surface_file part = part_of(input.file, faces[c]);
      const std::string path = snapshot_path(session.options().output, static_cast<int>(c));
      write_mesh(path, part, session);
      paths.push_back(path);
      grid.add({std::to_string(c), std::to_string(part.points.size()),
                std::to_string(part.polygons.size()), path});
    }
  } catch (const Write_error&) {  // such as of a full disk: all parts or none
    for (const std::string& path : paths) std::filesystem::remove(path);
    throw;
  }
  session.report().show(grid);
  return paths;
}

/// where the vertices of the files were, those of one after those of the other
void tell_vertices(const Surface_input& input, const std::vector<std::vector<int>>& faces,
                   Report& report)
{
  std::vector<int> vertices, sizes;
  for (const std::vector<int>& own : faces) {
    const std::vector<int> some = vertices_of(input.file, own);
    vertices.insert(vertices.end(), some.begin(), some.end());
    sizes.push_back(static_cast<int>(some.size()));
  }
  report.set("result/vertices", Report::Value(sizes));
  report.set("result/vertex_before_split", Report::Value(vertices));
}

void split(const Split_options& options, Session& session)
{
  const std::string& output = session.options().output;
  require_writable(output);
  const Surface_input input = read_surface_input(options.input, session.options().repair);
  session.end_stage("read");
  session.note_all(input.notes);
  report_input(input, session.report());
  const auto faces = faces_of_components(input, options.min_faces);
  if (faces.empty())
    throw unsuitable(options.input, "no component has so many faces; try: a smaller --min-faces");
  require_new_files("component", output, static_cast<int>(faces.size()), {options.input});
  session.report().set("result/files", Report::Value(write_parts(input, faces, session)));
  session.report().set("result/components", static_cast<int>(faces.size()));
  tell_vertices(input, faces, session.report());
  session.end_stage("write");
}

}  // namespace

Command split_command()
{
  return make_command<Split_options>("split", split_about, add_options, files, split);
}

}  // namespace conformal
