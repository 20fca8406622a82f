// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Command.h"
#include "keyed_options.h"
#include "option_groups.h"

#include "conformal/io/data/texture_coordinates.h"
#include "conformal/io/file/numbers.h"
#include "conformal/process/at.h"
#include "conformal/process/interruption.h"
#include "conformal/process/text.h"
#include "conformal/report/keep_exhibit.h"
#include "conformal/transform/cut_overlaps.h"
#include "conformal/transform/each_component.h"
#include "conformal/transform/flat_image.h"
#include "conformal/transform/suitable_surface.h"
#include "conformal/transform/write_result.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace conformal {
namespace {

const char* const flatten_about =
    "Maps a surface with boundary to the plane with little distortion of angles, and writes the\n"
    "map as texture coordinates in the unit square, beside the mesh as it was, or the flat mesh\n"
    "itself, as large as the surface. Holes are taken as they come. The property quality is the\n"
    "quasi-conformal error.\n"
    "--planar has the surface unbend by curvature: its mean curvature becomes zero, and the\n"
    "tangents of its boundary, which must be one loop, those of a plane curve that turns as it\n"
    "did. Where the boundary is small against the surface, lengths change most, and faces have to\n"
    "be small.\n"
    "--cut opens closed surfaces first. Where parts of their image would overlap, it is cut into\n"
    "charts side by side.\n"
    "Example: conformal flatten face.off -o face.glb --json face.json";

constexpr int least_tips = 4, most_tips = 64;

/// `7` or `7:90`
Cone cone_of(const std::string& word)
{
  const std::size_t colon = word.find(':');
  const auto vertex = parse_integer(word.substr(0, colon));
  std::optional<double> angle;
  if (colon != std::string::npos) angle = parse_double(word.substr(colon + 1));
  const bool has_angle = angle && *angle > 0 && std::isfinite(*angle);
  const bool is_vertex = vertex && *vertex >= 0 && *vertex <= std::numeric_limits<int>::max();
  if (!is_vertex || (colon != std::string::npos && !has_angle))
    throw CLI::ValidationError("--cones", in_quotes(word) + " is not a vertex, wanted 7 or 7:90");
  Cone cone{static_cast<int>(*vertex)};
  if (has_angle) cone.defect = 2 * std::acos(-1.) - *angle * std::acos(-1.) / 180;
  return cone;
}

std::vector<Cone> cones_of(const std::vector<std::string>& words)
{
  std::vector<Cone> cones;
  for (const std::string& word : words) cones.push_back(cone_of(word));
  return cones;
}

void add_options(CLI::App& command, Flatten_options& options, Common_options& common)
{
  add_input(command, options.input);
  add_transformation(command, common);
  CLI::Option* method = add_choice(
      command, "--method", options.method, {"spectral", "dirac", "cones"},
      "spectral (normals of the faces), or as in the thesis with those of the vertices: "
      "dirac, which is worse on scans; or cones, with --cut if the surface is closed: cuts "
      "with equal sides, through cones that keep areas; a boundary keeps its shares of "
      "length");
  CLI::Option* loops =
      command.add_flag("--all-loops", options.all_loops,
                       "keep the spread of all boundary loops, and not of the longest alone");
  command.add_flag("--planar", options.planar, "by curvature, and not by an energy")
      ->excludes(method)
      ->excludes(loops);
  const auto set_tips = [&options](const std::string& text) {
    options.cut.finds_tips = text == "0";
    options.cut.tips = options.cut.finds_tips ? least_tips : std::stoi(text);
  };
  command
      .add_flag("--cut{0}",
                "cut closed surfaces open (with --method cones any), by short cuts through so many "
                "tips (--cut=2; default "
                "the first of 4, 8, ... 64 that verifies) and around handles; texture coordinates "
                "jump there, and the flat mesh is open")
      ->check(CLI::NonNegativeNumber)
      ->each(set_tips);
  command
      .add_option_function<std::vector<std::string>>(
          "--cones", [&options](const auto& words) { options.cut.cones = cones_of(words); },
          "cut surfaces open likewise, through these vertices in place of tips: 7,12,19; of "
          "--method "
          "cones with angles in degrees, if you like: 7:90,12,19")
      ->delimiter(',');
  command.add_flag("--planar-mesh", options.planar_mesh,
                   "write the flat mesh, and not the surface with texture coordinates alone; after "
                   "--cut, JSON has the number before of each vertex (vertex_before_cuts)");
  advanced(command)
      .add_option("--tolerance", options.tolerance, "of the spectral map")
      ->check(between_zero_and_one)
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

/// of a component that was cut through cones
Seams seams_of(const Cut_surface& surface, const Component& component)
{
  if (surface.log_scale.size() == 0) return {};
  std::vector<int> origin;
  for (const int v : component.vertices) {
    const auto copy = static_cast<std::size_t>(surface.input.vertex_in_file[at(v)]);
    origin.push_back(surface.origin[copy]);
  }
  return CGP::internal::seams_of(component.input.mesh, origin,
                                 surface.log_scale(component.vertices));
}

Flat_components flatten_components(const Cut_surface& surface, const Flatten_options& options,
                                   Session& session)
{
  const Surface_input& input = surface.input;
  const int n = input.mesh.size_of_vertices();
  Flat_components flat{CGP::Points::Zero(3, n), std::vector<char>(static_cast<std::size_t>(n), 0)};
  each_component(input, session, [&](const Component& component, Session& own) {
    require_boundary(component.input);
    flat.positions(Eigen::indexing::all, component.vertices) =
        flat_image(component.input, seams_of(surface, component), options, own);
    for (const int v : component.vertices) flat.has_image[static_cast<std::size_t>(v)] = 1;
  });
  if (session.options().each_component) place_apart(input.mesh, flat.positions);
  return flat;
}

/// the image, and those without one as they were
CGP::Points with_those_left(const CGP::Mesh_view& mesh, const Flat_components& flat)
{
  CGP::Points positions = flat.positions;
  for (int v = 0; v < mesh.size_of_vertices(); ++v)
    if (!flat.has_image[static_cast<std::size_t>(v)]) positions.col(v) = mesh.position(v);
  return positions;
}

/// the file before cuts, with texture coordinates that jump there, and quality
Surface_file textured(Surface_file file, const Cut_surface& cut,
                      const std::vector<std::array<double, 2>>& texture,
                      const std::vector<float>& quality)
{
  Corner_values values;
  for (const auto& [u, v] : texture) values.values.push_back({u, v, 0});
  values.index = cut.input.file.polygons.corners;
  set_texture_coordinates(file, std::move(values));
  std::vector<float> at_vertices(file.points.size(), 1);
  for (std::size_t i = quality.size(); i-- > 0;)  // of copies the first one counts
    at_vertices[static_cast<std::size_t>(cut.origin[i])] = quality[i];
  set_property(file.vertices, "quality", at_vertices);
  return file;
}

Surface_input read_input(const Flatten_options& options, Session& session)
{
  return options.cut.opens_closed() ? read_suitable_surface(options.input, session)
                                    : read_bounded_surface(options.input, session);
}

Cut_surface opened(const Surface_input& input, const Cut_options& options)
{
  if (options.opens_closed() || options.makes_flat) return cut_open(input, options);
  return {input, {}, {}, {}};
}

/// which cones the metric has
void tell(const std::vector<Cone>& cones, Report& report)
{
  if (cones.empty()) return;
  std::vector<int> vertices;
  std::vector<double> angles;
  for (const Cone& cone : cones) {
    vertices.push_back(cone.vertex);
    angles.push_back(360 - *cone.defect * 180 / std::acos(-1.));
  }
  const auto [least, greatest] = std::minmax_element(angles.begin(), angles.end());
  report.show("cones", std::to_string(cones.size()) + ", of " + text_of(*least, 4) + " to " +
                           text_of(*greatest, 4) + " degrees");
  report.set("result/cones/vertices", std::move(vertices));
  report.set("result/cones/angles", std::move(angles));
}

void tell_charts(int charts, Report& report)
{
  if (charts > 0) report.tell("result/charts", "charts side by side, so that none overlap", charts);
}

/// a surface that is cut where it was closed, and its image
struct Opened_image {
  Cut_surface surface;
  Flat_components flat;
};

/// With twice as many tips as long as the image does not verify.
Opened_image open_and_flatten(const Surface_input& input, Flatten_options& options,
                              Session& session)
{
  for (;; options.cut.tips *= 2) {
    const Outcome before = session.outcome();
    try {
      Cut_surface surface = opened(input, options.cut);
      tell(surface.cones, session.report());
      Flat_components flat = flatten_components(surface, options, session);
      return {std::move(surface), std::move(flat)};
    } catch (const Failure& failure) {
      const bool can_go_on = options.cut.finds_tips && options.cut.tips < most_tips;
      if (failure.code() != Exit_code::failed || !can_go_on) throw;
      session.outcome() = before;
    }
  }
}

/// the flat mesh, or the one before with the map as texture coordinates
Surface_file file_of(const Cut_surface& surface, Surface_file&& before, const Flat_components& flat,
                     const Flatten_options& options)
{
  const Surface_input& input = surface.input;
  const auto texture = in_unit_square(input, flat.positions);
  const CGP::Points shown = with_those_left(input.mesh, flat);
  if (!surface.origin.empty() && !options.planar_mesh)
    return textured(std::move(before), surface, texture, quality(input, shown));
  Surface_file file = options.planar_mesh ? moved(input, shown) : std::move(before);
  set_texture_coordinates(file, texture);
  set_quality(input, shown, file);
  return file;
}

void require_possible(const Surface_input& input, const std::vector<Cone>& cones, bool makes_flat)
{
  const std::vector<int>& all = input.vertex_in_file;
  for (const Cone& cone : cones) {
    if (cone.defect && !makes_flat)
      throw Failure(Exit_code::usage, "the angle of vertex " + std::to_string(cone.vertex) +
                                          " is for --method cones; try: --cones without it");
    if (std::find(all.begin(), all.end(), cone.vertex) == all.end())
      throw unsuitable(input.file.path, "--cones: no face has a vertex " +
                                            std::to_string(cone.vertex) + "; they count from 0");
  }
}

void flatten(const Flatten_options& given, Session& session)
{
  Flatten_options options = given;
  options.cut.makes_flat = options.method == Flatten_method::cones;
  const std::string& output = session.options().output;
  require_writable(output);
  const Surface_input input = read_input(options, session);
  require_possible(input, options.cut.cones, options.cut.makes_flat);
  Surface_file before = input.file;
  auto [surface, flat] = open_and_flatten(input, options, session);
  if (!surface.origin.empty()) tell_charts(cut_overlaps(surface, flat), session.report());
  if (options.planar_mesh && !surface.origin.empty())
    session.report().set("result/vertex_before_cuts", surface.origin);
  if (options.cut.tips > 0) session.report().set("result/tips", options.cut.tips);
  keep_flat_exhibit(surface.input, with_those_left(surface.input.mesh, flat), session);
  write_mesh(output, file_of(surface, std::move(before), flat, options), session);
  session.end_stage("write");
}

}  // namespace

Command flatten_command()
{
  return make_command<Flatten_options>("flatten", flatten_about, add_options, files, flatten);
}

}  // namespace conformal
