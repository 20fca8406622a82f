// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests include/Conformal_geometry_processing/conformal_willmore_flow.h
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <string>

#include "conformal_willmore_flow_boundary_checks.h"

namespace cgp_test::conformal_willmore_flow_boundary_tests {

namespace params = CGP::parameters;
using Surface = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

Surface cap()
{
  return to_cgal_mesh<Surface>(bumpy_cap_of_few_faces());
}

/// whether the flow refuses the mesh for this reason, and leaves it alone
template <class NamedParameters>
bool refuses(Surface mesh, const NamedParameters& np, const std::string& reason)
{
  const Points before = view_of(mesh).positions();
  try {
    (void)CGP::conformal_willmore_flow(mesh, np);
  } catch (const CGP::Precondition_error& error) {
    return error.function() == "conformal_willmore_flow" &&
           error.message().find(reason) != std::string::npos && view_of(mesh).positions() == before;
  }
  return false;
}

TEST(Conformal_willmore_flow_of_a_disk, leaves_its_boundary_free)
{
  expect_flow_with(cap(), params::number_of_iterations(2), Boundary_condition::free(), 1e-14);
}

TEST(Conformal_willmore_flow_of_a_disk, keeps_a_direction_of_its_boundary)
{
  const CGP::Boundary_direction between{1, .2, .3};
  expect_flow_with(cap(), params::boundary_direction(between).number_of_iterations(2),
                   Boundary_condition::directions({1, .2, .3}), 1e-14);
}

TEST(Conformal_willmore_flow_of_a_disk, turns_its_boundary)
{
  expect_flow_with_binormals(cap(), 1e-14);
}

TEST(Conformal_willmore_flow_of_a_disk, refuses_balance)
{
  for (const CGP::Flow_options::Balance balance :
       {CGP::Flow_options::Balance::initial, CGP::Flow_options::Balance::canonical})
    EXPECT_TRUE(refuses(cap(), params::balance(balance), "a closed surface is needed"));
}

TEST(Conformal_willmore_flow_of_a_disk, refuses_normals_and_boundaries_of_closed_surfaces)
{
  const CGP::Boundary_direction tangent{1, 0, 0}, normal{0, 1, 0};
  EXPECT_TRUE(refuses(cap(), params::boundary_direction(normal), "not elliptic"));
  EXPECT_TRUE(refuses(to_cgal_mesh<Surface>(icosphere(1)), params::boundary_direction(tangent),
                      "the surface is closed"));
}

}  // namespace cgp_test::conformal_willmore_flow_boundary_tests
