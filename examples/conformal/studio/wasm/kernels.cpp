// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// What the page calls: plain functions over arrays in the memory of the module.
#include "conformal/studio/Studio_surface.h"

#include <Conformal_geometry_processing/spin/Scale_control.h>

#include <exception>
#include <functional>
#include <memory>
#include <new>
#include <string>
#include <vector>

#define STUDIO_EXPORT extern "C" __attribute__((used))

namespace {

using namespace conformal;

std::unique_ptr<Studio_surface> the_surface;
std::vector<float> the_quality;
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
