// Tests examples/conformal/commands/flow.cpp examples/conformal/commands/boundary.cpp
// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/read_surface.h"
#include "program/support.h"
#include "support/bounded_meshes.h"
#include "support/spheres.h"
#include "support/tori.h"

#include <cmath>

namespace {

using namespace program_test;

class Scales : public Program {
 protected:
  /// the points that a command makes of a surface of this size, divided by the size
  Eigen::Matrix3Xd result(const cgp_test::Mesh_view& mesh, double size, const std::string& command)
  {
    write("a.off", off(cgp_test::scaled(mesh, size)));
    const Program_run r = run(command + " a.off -q -o b.off");
    EXPECT_EQ(r.code, 0) << command << ' ' << size << r.err;
    const auto points = conformal::read_surface(path("b.off")).points;
    Eigen::Matrix3Xd all(3, static_cast<Eigen::Index>(points.size()));
    for (Eigen::Index v = 0; v < all.cols(); ++v)
      all.col(v) = Eigen::Vector3d::Map(points[static_cast<std::size_t>(v)].data()) / size;
    return all;
  }

  void expect_the_same_at_all_sizes(const cgp_test::Mesh_view& mesh, const std::string& command)
  {
    const Eigen::Matrix3Xd wanted = result(mesh, 1, command);
    for (const double size : {1e-150, 1e-82, 1e78, 1e150})
      EXPECT_LT((result(mesh, size, command) - wanted).norm(), 1e-6 * wanted.norm())
          << command << ' ' << size;
  }
};

TEST_F(Scales, of_closed_surfaces_do_not_matter)
{
  const auto ball = cgp_test::bumpy_sphere(2);
  for (const std::string command : {"spin --rho-expression .3*z",
                                    "spin --mollify=1e-6 --rho-expression .3*z", "flow --steps 2"})
    expect_the_same_at_all_sizes(ball, command);
}

TEST_F(Scales, of_handles_do_not_matter)
{
  const auto torus = cgp_test::torus(2, 1, 20, 12);
  for (const std::string command : {"spin --rho-expression .1*z", "flow --steps 2"})
    expect_the_same_at_all_sizes(torus, command);
}

TEST_F(Scales, of_surfaces_with_boundary_do_not_matter)
{
  const auto cap = cgp_test::cap_from_disk(cgp_test::jittered_disk(8, .3), 1);
  for (const std::string command :
       {"boundary --binormal-tilt '10*cos(4*pi*s)'", "boundary --tangent-rotation '5*cos(4*pi*s)'",
        "spin --boundary tangents --rho-expression .3*z", "flatten --planar-mesh"})
    expect_the_same_at_all_sizes(cap, command + (command[0] == 'b' ? " --force" : ""));
}

}  // namespace
