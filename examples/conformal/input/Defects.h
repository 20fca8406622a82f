// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Surface_input.h"

#include <string>
#include <vector>

namespace conformal {

/// whether faces of area zero are a defect
enum class Flat_faces { refused, allowed };

/// Reasons why a mesh is not one oriented manifold surface with positive areas, in terms of the
/// user's file: number of elements, the first of them, and advice.
struct Defects {
  std::vector<std::string> of_topology;    ///< non-manifold, not orientable
  std::vector<std::string> of_geometry;    ///< faces of area zero, coordinates too large
  std::vector<std::string> of_components;  ///< more than one
  bool has_area = true;  ///< the only geometric defects are faces of area zero, but not all faces

  /// the first one, or an empty string
  std::string first(Flat_faces flat_faces = Flat_faces::refused) const;
};

Defects find_defects(const Surface_input& input);

/// the shape of the surface in numbers, `V 12, E 30, F 20, closed, genus 0`, as a user is told
/// \pre the mesh has no defects of topology
std::string description(const CGP::Mesh_view& mesh);

/// \throws Failure naming the first defect
void require_surface(const Surface_input& input, Flat_faces flat_faces = Flat_faces::refused);

/// Likewise, for any number of components
void require_surface_components(const Surface_input& input,
                                Flat_faces flat_faces = Flat_faces::refused);

/// the same as `require_surface()`, and no boundary
void require_closed_surface(const Surface_input& input);

/// \throws Failure if something was done to the input that it did not ask for
void require_untouched(const Surface_input& input);

}  // namespace conformal
