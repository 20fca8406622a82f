// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// What the page calls: plain functions over arrays in the memory of the module.
#include "conformal/studio/Studio_shape.h"
#include "conformal/studio/Studio_surface.h"

#include <Conformal_geometry_processing/spin/Scale_control.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <vector>

#define STUDIO_EXPORT extern "C" __attribute__((used))

namespace {

using namespace conformal;

std::unique_ptr<Studio_surface> the_surface;
std::vector<float> the_quality;
struct {
  std::optional<Studio_shape> shape;
  std::vector<float> squares;
} the_file;            // read last
std::string the_text;  // of the report, or of the error

/// whether it succeeded; otherwise the text is that of the error
bool carry_out(const std::function<void()>& work)
{
  try {
    work();
    return true;
  } catch (const CGP::Error& error) {
    the_text = error.message();
  } catch (const std::bad_alloc&) {
    the_text = "out of memory; try: a coarser mesh";
  } catch (const std::exception& error) {
    the_text = error.what();
  }
  return false;
}

Eigen::VectorXd values(const double* rho)
{
  return Eigen::Map<const Eigen::VectorXd>(rho, the_surface->positions().cols());
}

/// Does the work, and keeps what it has to tell.
bool edit(const std::function<void()>& work)
{
  return carry_out([&] {
    work();
    const Eigen::VectorXd Q = the_surface->quality().cwiseMin(1e30);
    the_quality.assign(Q.begin(), Q.end());
    the_text = to_json(the_surface->outcome());
  });
}

}  // namespace

STUDIO_EXPORT double studio_default_bound()
{
  return CGP::internal::default_scale_bound;
}

/// Reads a file that somebody has dropped on the page; the text tells about it.
STUDIO_EXPORT bool studio_read(const char* bytes, int size, const char* name, bool is_repaired)
{
  return carry_out([&] {
    the_file = {};
    the_file.shape = parse_shape({bytes, static_cast<std::size_t>(size)}, name, is_repaired);
    the_file.squares = squares_of(*the_file.shape);
    the_text = nlohmann::json({{"vertices", the_file.shape->mesh.size_of_vertices()},
                               {"faces", the_file.shape->mesh.size_of_faces()},
                               {"fileVertices", the_file.shape->file_vertices},
                               {"notes", the_file.shape->notes}})
                   .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  });
}

STUDIO_EXPORT const double* studio_file_positions()
{
  return the_file.shape->mesh.positions().data();
}

STUDIO_EXPORT const int* studio_file_faces()
{
  return the_file.shape->mesh.corners().front().data();
}

STUDIO_EXPORT const float* studio_file_squares()
{
  return the_file.squares.data();
}

/// of each vertex, its number in the file
STUDIO_EXPORT const int* studio_file_origin()
{
  return the_file.shape->vertex_in_file.data();
}

STUDIO_EXPORT bool studio_open(const double* positions, int vertices, const int* corners, int faces)
{
  return carry_out([&] {
    the_surface.reset();
    CGP::Mesh_view::Corners all(static_cast<std::size_t>(faces));
    for (std::size_t f = 0; f < all.size(); ++f)
      all[f] = {corners[3 * f], corners[3 * f + 1], corners[3 * f + 2]};
    const CGP::Points points = Eigen::Map<const CGP::Points>(positions, 3, vertices);
    the_surface = std::make_unique<Studio_surface>(CGP::Mesh_view(points, std::move(all)));
  });
}

STUDIO_EXPORT bool studio_preview(const double* rho, double bound, bool continues)
{
  return edit([&] { the_surface->preview(values(rho), bound, continues); });
}

STUDIO_EXPORT bool studio_transform(const double* rho, double bound)
{
  return edit([&] { the_surface->transform(values(rho), bound); });
}

/// \param vertices numbers of the control points, \param targets 3 coordinates of each
STUDIO_EXPORT bool studio_deform(const int* vertices, const double* targets, int count,
                                 double bound, bool continues)
{
  return edit([&] {
    std::vector<CGP::internal::Control_point> points;
    for (int i = 0; i < count; ++i)
      points.push_back(CGP::internal::control_point(
          vertices[i], Eigen::Map<const Eigen::Vector3d>(targets + 3 * i)));
    the_surface->deform(points, bound, continues);
  });
}

STUDIO_EXPORT bool studio_flow()
{
  return edit([] { the_surface->flow(); });
}

STUDIO_EXPORT const double* studio_positions()
{
  return the_surface->positions().data();
}

STUDIO_EXPORT const float* studio_quality()
{
  return the_quality.data();
}

STUDIO_EXPORT const char* studio_text()
{
  return the_text.c_str();
}
