// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "flatten.h"

#include "conformal/input/Surface_input.h"
#include "conformal/io/data/texture_coordinates.h"
#include "conformal/io/write_surface.h"
#include "conformal/process/Failure.h"
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

void verify(const Flat_image& image, const Flatten_options& options, Session& session)
{
  session.report().set("verified", image.fault.empty());
  if (image.fault.empty()) return;
  if (!options.force) throw Failure(Exit_code::failed, options.input + ": " + image.fault);
  session.note("written all the same, as --force says: " + image.fault);
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

/// The image of a surface in one component, which verifies.
CGP::Points flattened(const Surface_input& input, const Flatten_options& options, Session& session)
{
  Flat_image image = flat_image(input, options, session);
  throw_if_interrupted();
  session.end_stage("solve");
  verify(image, options, session);
  return std::move(image.positions);
}

/// The images of all components, side by side.
CGP::Points flattened_components(const Surface_input& input, const Flatten_options& options,
                                 Session& session)
{
  CGP::Points positions =
      each_component(input, session, [&](const Component& component, Session& own) {
        return flattened(component.input, options, own);
      });
  Eigen::VectorXcd z(positions.cols());
  z.real() = positions.row(0).transpose();
  z.imag() = positions.row(1).transpose();
  CGP::place_side_by_side(CGP::connected_components(input.mesh), z);
  positions.topRows<2>() = CGP::in_space(z).topRows<2>();
  return positions;
}

}  // namespace

void flatten(const Flatten_options& options, Session& session)
{
  const std::string& output = session.options().output;
  require_writable(output);
  const Surface_input input = read_bounded_surface(options.input, session);
  const CGP::Points positions = session.options().each_component
                                    ? flattened_components(input, options, session)
                                    : flattened(input, options, session);
  keep_flat_exhibit(input, positions, session);
  Surface_file file = options.planar_mesh ? moved(input, positions) : input.file;
  set_texture_coordinates(file, in_unit_square(input, positions));
  set_quality(input, positions, file);
  session.note_all(write_surface(output, file));
  session.end_stage("write");
}

}  // namespace conformal
