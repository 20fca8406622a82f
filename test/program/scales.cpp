// Tests examples/conformal/commands/flow.cpp examples/conformal/commands/boundary.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/file/numbers.h"
#include "program/bounded_support.h"
#include "support/mesh_tools.h"
#include "support/moebius.h"
#include "support/random.h"
#include "support/spheres.h"
#include "support/tori.h"

#include <cmath>

namespace cgp_test::scales_tests {

using namespace program_test;
using cgp_test::Mesh_view;
using Commands = std::vector<std::string>;

/// a surface, and a conformal image of it
struct Pair {
  Mesh_view a, b;
};

Pair inverted_pair(const Mesh_view& a)
{
  return {a, cgp_test::inverted(a, Eigen::Vector3d(.5, .4, 6))};
}

/// Every command on every kind of surface gives the same result at all sizes.
class Scales : public Bounded_program {
 protected:
  /// Writes the surfaces a.off and b.off, and t.json, which moves a vertex and holds three.
  void write_inputs(const Pair& pair, double size)
  {
    write("a.off", off(cgp_test::scaled(pair.a, size)));
    write("b.off", off(cgp_test::scaled(pair.b, size)));
    std::string targets;
    for (int k = 0; k < 4; ++k) {
      const int v = k * (pair.a.size_of_vertices() - 1) / 3;
      targets += (k == 0 ? "{\"vertex\": " : ", {\"vertex\": ") + std::to_string(v) +
                 ", \"move\": [0, 0, ";
      conformal::append_number(targets, k == 0 ? .1 * size : 0);
      targets += "]}";
    }
    write("t.json", "{\"targets\": [" + targets + "]}");
  }

  /// the points that a command makes of surfaces of this size, divided by the size
  Points result(const Pair& pair, double size, const std::string& command)
  {
    write_inputs(pair, size);
    const Program_run r = run(command + " -q -o c.off --json c.json");
    EXPECT_EQ(r.code, 0) << command << ' ' << size << r.err;
    return r.code == 0 ? Points(points("c.off") / size) : Points(3, 0);
  }

  /// the measures of a map: they have no unit, and all but errors are about 1
  std::vector<double> map() const
  {
    const auto result = json("c.json")["result"];
    if (!result.contains("quasi_conformal")) return {};
    const auto &Q = result["quasi_conformal"], &scale = result["scale"];
    return {Q["mean"], Q["max"], result["length_cross_ratio"]["rms"], scale["min"], scale["max"]};
  }

  void expect_the_same_at_all_sizes(const Pair& pair, const Commands& commands,
                                    double tolerance = 1e-6)
  {
    for (const std::string& command : commands) {
      const Points wanted = result(pair, 1, command);
      const std::vector<double> wanted_map = map();
      for (const double size : {1e-150, 1e-82, 1e78, 1e150}) {
        const Points found = result(pair, size, command);
        ASSERT_EQ(found.cols(), wanted.cols()) << command << ' ' << size;
        EXPECT_LT((found - wanted).norm(), tolerance * wanted.norm()) << command << ' ' << size;
        const std::vector<double> found_map = map();
        for (std::size_t k = 0; k < wanted_map.size(); ++k)
          EXPECT_NEAR(found_map[k], wanted_map[k], 10 * tolerance)
              << command << ' ' << size << ' ' << k;
      }
    }
  }
};

// The vertices are displaced, for ties between cuts would be decided by rounding.
Pair balls()
{
  return inverted_pair(cgp_test::perturbed(cgp_test::bumpy_sphere(2), .02));
}

Pair rings()
{
  return inverted_pair(cgp_test::irregular_torus(2, 1, 20, 12));
}

Pair caps()
{
  return inverted_pair(cgp_test::cap_from_disk(cgp_test::jittered_disk(8, .3), 1));
}

TEST_F(Scales, of_closed_surfaces_do_not_matter)
{
  expect_the_same_at_all_sizes(
      balls(),
      {"spin a.off --rho-expression .3*z", "spin a.off --mollify=1e-6 --rho-expression .3*z",
       "spin a.off --exact-class --rho-expression .3*z",
       "spin a.off --max-scale 1.05 --rho-expression '.5*sin(3*z)'", "flow a.off --steps 2",
       "flow a.off --plain --steps 2", "flatten a.off --cut --planar-mesh"});
}

TEST_F(Scales, of_closed_surfaces_and_their_targets_do_not_matter)
{
  expect_the_same_at_all_sizes(
      balls(),
      {"compare a.off b.off", "fit a.off b.off", "fit a.off b.off --max-scale 1.1",
       "blend a.off b.off --t .5", "deform a.off --targets t.json",
       "fair a.off --region-expression z-.1", "fair a.off --outline --region-expression z-.1"});
}

TEST_F(Scales, of_handles_do_not_matter)
{
  expect_the_same_at_all_sizes(
      rings(),
      {"spin a.off --rho-expression .1*z", "spin a.off --exact-class --rho-expression .1*z",
       "spin a.off --max-scale 1.05 --rho-expression .5*z", "flow a.off --steps 2",
       "flow a.off --plain --steps 2", "flatten a.off --cut --planar-mesh"});
}

TEST_F(Scales, of_handles_and_their_targets_do_not_matter)
{
  expect_the_same_at_all_sizes(rings(), {"compare a.off b.off", "deform a.off --targets t.json",
                                         "fair a.off --region-expression x-.5"});
}

// Their searches end after some ninety inexact steps: where within the tolerance, rounding decides.
TEST_F(Scales, of_handles_and_the_nearest_surfaces_hardly_matter)
{
  expect_the_same_at_all_sizes(rings(), {"fit a.off b.off", "blend a.off b.off --t .5"}, 1e-3);
}

TEST_F(Scales, of_surfaces_with_boundary_do_not_matter)
{
  expect_the_same_at_all_sizes(
      caps(),
      {"boundary a.off --force --binormal-tilt '10*cos(4*pi*s)'",
       "boundary a.off --force --tangent-rotation '5*cos(4*pi*s)'",
       "spin a.off --boundary tangents --rho-expression .3*z",
       "spin a.off --boundary tangents --exact-class --rho-expression .1*z",
       "spin a.off --boundary tangents --max-scale 1.05 --rho-expression '.5*z'",
       "flow a.off --boundary binormals --steps 2", "flatten a.off --planar-mesh",
       "flatten a.off --method dirac --planar-mesh", "flatten a.off --planar --planar-mesh"});
}

TEST_F(Scales, of_surfaces_with_boundary_and_their_targets_do_not_matter)
{
  expect_the_same_at_all_sizes(
      caps(), {"compare a.off b.off", "fit a.off b.off", "deform a.off --targets t.json",
               "fair a.off --region-expression z-.1"});
  // whose rho is corrected by what several transformations leave, which amplifies rounding
  expect_the_same_at_all_sizes(caps(), {"blend a.off b.off --t .5"}, 1e-5);
}

}  // namespace cgp_test::scales_tests
