// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/input/Surface_input.h"

#include <Conformal_geometry_processing/mesh/Mesh_component.h>
#include <Conformal_geometry_processing/operators/Curvature_potential.h>
#include <Conformal_geometry_processing/spin/Boundary_condition.h>

#include <vector>

namespace conformal {

/// \brief one component of a surface, or the whole of it, in an order of its own that does not
/// depend on that of the file, see `in_morton_order()`
struct Component {
  const Surface_input& input;        ///< as if there were no other
  std::vector<int> vertices, faces;  ///< in the mesh of the whole surface
};

/// the whole of a surface as its only component
CGP::internal::Mesh_component whole_of(const CGP::Mesh_view& mesh);

/// the whole of a surface, with the elements of its mesh, which is taken, in another order
Surface_input reordered(CGP::internal::Mesh_component& all, Surface_input whole);

/// a component as an input of its own, whose elements have their names in the file
Surface_input input_of(const CGP::internal::Mesh_component& part, const Surface_input& whole);

/// the part of rho on a component, times a factor
CGP::Curvature_potential on_component(const CGP::Curvature_potential& rho,
                                      const Component& component, double factor);

/// the part of a boundary condition that concerns a component of a surface
CGP::Boundary_condition on_component(const CGP::Boundary_condition& condition,
                                     const CGP::Mesh_view& whole, const Component& component);

/// the component of another surface with the same faces
CGP::Mesh_view on_component(const CGP::Mesh_view& other, const Component& component);

/// Turns the closed components around that are inside out, as a file with one of them would be.
void turn_components_outward(Surface_input& input);

}  // namespace conformal
