// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "commands.h"
#include "option_groups.h"

#include "conformal/io/data/texture_coordinates.h"
#include "conformal/io/write_surface.h"
#include "conformal/process/interruption.h"
#include "conformal/report/keep_exhibit.h"
#include "conformal/transform/each_component.h"
#include "conformal/transform/flat_image.h"
#include "conformal/transform/suitable_surface.h"
#include "conformal/transform/write_result.h"

#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/parameterization/place_in_plane.h>
#include <Conformal_geometry_processing/parameterization/place_side_by_side.h>

#include <algorithm>
#include <array>
#include <vector>

namespace conformal {
namespace {

const char* const about =
    "Maps a surface with boundary to the plane with little distortion of angles, and writes the\n"
    "map as texture coordinates in the unit square, beside the mesh as it was, or the flat mesh\n"
    "itself, as large as the surface. Holes are taken as they come. The property quality is the\n"
    "quasi-conformal error.\n"
    "--planar has the surface unbend by curvature: its mean curvature becomes zero, and the\n"
    "tangents of its boundary, which must be one loop, those of a plane curve that turns as it\n"
    "did.\n"
    "Example: conformal flatten face.off -o face.glb --json face.json";

void add_options(CLI::App& command, Flatten_options& options, Common_options& common)
{
  add_input(command, options.input);
  add_transformation(command, common);
  CLI::Option* method =
      add_choice(command, "--method", options.method, {"spectral", "dirac"},
                 "spectral (normals of the faces), or as in the thesis with those of the vertices: "
                 "dirac, which is worse on scans");
  CLI::Option* loops =
      command.add_flag("--all-loops", options.all_loops,
                       "keep the spread of all boundary loops, and not of the longest alone");
  command.add_flag("--planar", options.planar, "by curvature, and not by an energy")
      ->excludes(method)
      ->excludes(loops);
  command.add_flag("--planar-mesh", options.planar_mesh,
                   "write the flat mesh, and not the surface with texture coordinates alone");
  command.add_option("--tolerance", options.tolerance, "of the spectral map")
      ->check(above_zero)
      ->capture_default_str();
  add_limits(command, options.limits, options.force);
}

Files files(const Flatten_options& flatten)
{
  return {{"the input", flatten.input, Named_file::Role::replaceable}};
}

/// \brief texture coordinates in the unit square, of the same shape as the image, at its lower left
/// corner; (0, 0) for vertices without a face.
std::vector<std::array<double, 2>> in_unit_square(const Surface_input& input,
                                                  const CGP::Points& positions)
{
  const Eigen::Vector2d low = positions.topRows<2>().rowwise().minCoeff();
  const Eigen::Vector2d extent = positions.topRows<2>().rowwise().maxCoeff() - low;
  std::vector<std::array<double, 2>> uv(input.file.points.size(), {0, 0});
  for (std::size_t v = 0; v < input.vertex_in_file.size(); ++v) {
    const Eigen::Vector2d p =
        (positions.col(static_cast<Eigen::Index>(v)).head<2>() - low) / extent.maxCoeff();
    uv[static_cast<std::size_t>(input.vertex_in_file[v])] = {p.x(), p.y()};
  }
  return uv;
}

/// Moves the images of components side by side.
void place_apart(const CGP::Mesh_view& mesh, CGP::Points& positions)
{
  Eigen::VectorXcd z(positions.cols());
  z.real() = positions.row(0).transpose();
  z.imag() = positions.row(1).transpose();
  CGP::place_side_by_side(CGP::connected_components(mesh), z);
  positions.topRows<2>() = CGP::in_space(z).topRows<2>();
}

/// the image of all components; those without one are a point
struct Flat_components {
  CGP::Points positions;
  std::vector<char> has_image;  ///< of each vertex
};

Flat_components flatten_components(const Surface_input& input, const Flatten_options& options,
                                   Session& session)
{
  const int n = input.mesh.size_of_vertices();
  Flat_components flat{CGP::Points::Zero(3, n), std::vector<char>(static_cast<std::size_t>(n), 0)};
  each_component(input, session, [&](const Component& component, Session& own) {
    require_boundary(component.input);
    flat.positions(Eigen::indexing::all, component.vertices) =
        flat_image(component.input, options, own);
    for (const int v : component.vertices) flat.has_image[static_cast<std::size_t>(v)] = 1;
  });
  if (session.options().each_component) place_apart(input.mesh, flat.positions);
  return flat;
}

void flatten(const Flatten_options& options, Session& session)
{
  const std::string& output = session.options().output;
  require_writable(output);
  const Surface_input input = read_bounded_surface(options.input, session);
  Flat_components flat = flatten_components(input, options, session);
  const auto texture = in_unit_square(input, flat.positions);
  for (int v = 0; v < input.mesh.size_of_vertices(); ++v)
    if (!flat.has_image[static_cast<std::size_t>(v)])
      flat.positions.col(v) = input.mesh.position(v);
  keep_flat_exhibit(input, flat.positions, session);
  Surface_file file = options.planar_mesh ? moved(input, flat.positions) : input.file;
  set_texture_coordinates(file, texture);
  set_quality(input, flat.positions, file);
  session.note_all(write_surface(output, file));
  session.end_stage("write");
}

}  // namespace

Command flatten_command()
{
  return make_command<Flatten_options>("flatten", about, add_options, files, flatten);
}

}  // namespace conformal
