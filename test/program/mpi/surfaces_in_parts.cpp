// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Bounds on lengths, surfaces with handles and several boundaries, and STL files, in parts.
// Tests examples/conformal/mpi/Part_solver.h examples/conformal/mpi/Stl_ranges.cpp
#include "program/mpi/spin_in_parts.h"
#include "support/bounded_meshes.h"
#include "support/limbs.h"
#include "support/random.h"
#include "support/spheres.h"
#include "support/tori.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <vector>

namespace cgp_test::spin_in_parts_tests {

const std::string open_handles = "--open-handles ";

class Surfaces_in_parts : public Spin_in_parts {
 protected:
  /// whether lengths keep to the bound, which is felt, and all numbers are those of one.json
  void expect_same_within_bound(int processes, const std::string& arguments) const
  {
    expect_same(processes, arguments, 1e-6);
    const auto one = json("one.json")["scale_control"], all = json("all.json")["scale_control"];
    EXPECT_GT(double(all["weight"]), 0) << processes;
    EXPECT_LE(std::max(double(all["high"]), 1 / double(all["low"])), double(all["bound"]));
    for (const char* const name : {"kept_norm", "kept_correlation", "low", "high", "weight"})
      EXPECT_NEAR(all[name], one[name], 1e-5) << name;
  }

  /// a binary STL whose facets are in another order, with numbers as attributes
  void write_stl(const std::string& name, const Mesh_view& mesh) const
  {
    std::vector<int> order(static_cast<std::size_t>(mesh.size_of_faces()));
    for (std::size_t f = 0; f < order.size(); ++f) order[f] = static_cast<int>(f);
    std::shuffle(order.begin(), order.end(), std::mt19937(1));
    std::string text(80, ' ');
    const auto append = [&](const auto& value) {
      text.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    append(static_cast<std::uint32_t>(order.size()));
    for (const int f : order) {
      append(std::array<float, 3>{});
      for (const int v : mesh.corners(f)) append(near_zero(mesh.position(v), f));
      append(static_cast<std::uint16_t>(f % 7));
    }
    write(name, text);
  }

 private:
  // Zeros are negative in some facets.
  static Eigen::Vector3f near_zero(const Eigen::Vector3d& p, int f)
  {
    Eigen::Vector3f q = p.cast<float>();
    for (float& x : q)
      if (std::abs(x) < 1e-6f) x = f % 2 == 0 ? 0.f : -0.f;
    return q;
  }
};

TEST_F(Surfaces_in_parts, keep_to_the_bound_of_one_process)
{
  const std::string strong = wanted_rho + "--amplitude 3 ";
  const auto are_same = [&](const Mesh_view& surface, const std::string& bound,
                            const std::vector<int>& all, const std::string& solver = "") {
    write_ply("a.ply", surface);
    ASSERT_EQ(run("spin a.ply -o one.ply --json one.json " + bound + strong).code, 0);
    for (const int n : all) expect_same_within_bound(n, bound + solver + strong);
  };
  are_same(perturbed(bumpy_sphere(3), .02), "", {1, 2, 3});
  are_same(dumbbell(2), "--max-scale 1.3 ", {2, 3});
  are_same(perturbed(bumpy_sphere(2), .02), "", {2}, "--advanced solver=multigrid ");
}

// Killed in the search, or where its result closes up too little and the misfit has larger weights.
TEST_F(Surfaces_in_parts, are_resumed_to_the_same_surface_within_the_bound)
{
  write_ply("a.ply", dumbbell(3));
  const std::string bounded =
      "a.ply --json all.json --max-scale 1.3 --amplitude 3 --force" + wanted_rho;
  ASSERT_EQ(run_on(2, bounded + "-o all.ply").code, 0);
  const double closure = json("all.json")["closure_residual"];
  const std::string near = "--limit closure=" + std::to_string(.5 * closure) + " ";
  const auto are_resumed = [&](const std::string& arguments, const std::string& tries) {
    ASSERT_EQ(run_on(2, arguments + "-o all.ply").code, 0);
    const int spent = json("all.json")["iterations"];
    kill(2, 1, arguments, "b.ply", R"("numbers":\[)" + tries);
    ASSERT_EQ(run_on(3, arguments + "--resume -o b.ply").code, 0);
    EXPECT_LT(int(json("all.json")["iterations"]), spent);
    EXPECT_LE(double(json("all.json")["scale_control"]["high"]), 1.3);
    EXPECT_LT(difference("all.ply", "b.ply"), 1e-6) << tries;
    EXPECT_EQ(shell("rm b.ply").code, 0);
  };
  are_resumed(bounded, "0");
  are_resumed(bounded + near, "[1-4]");
}

TEST_F(Surfaces_in_parts, have_handles_that_are_left_open)
{
  write_ply("a.ply", perturbed(btorus(24), .01));
  for (const char* const bound : {"--max-scale none ", "--max-scale 1.3 "}) {
    const std::string arguments = open_handles + bound + wanted_rho + "--force ";
    run("spin a.ply -o one.ply --json one.json " + arguments);
    for (const int processes : {1, 2, 3, 4, 7}) expect_same(processes, arguments, 1e-6);
  }
}

TEST_F(Surfaces_in_parts, have_several_boundaries)
{
  const Mesh_view flat = annulus(.5, 1, 40, 8);
  Points p = flat.positions();
  for (Eigen::Index v = 0; v < p.cols(); ++v) p(2, v) = .4 * std::sin(2 * p(0, v) + p(1, v));
  write_ply("a.ply", perturbed({p, flat.corners()}, .01));
  for (const char* const bound : {"--max-scale none ", "--max-scale 1.3 "}) {
    const std::string arguments = open_handles + bound + wanted_rho + "--force ";
    run("spin a.ply -o one.ply --json one.json " + arguments);
    for (const int processes : {1, 2, 3, 7}) expect_same(processes, arguments, 1e-6);
  }
}

TEST_F(Surfaces_in_parts, are_read_from_stl_with_the_vertices_of_one_process)
{
  write_stl("a.stl", bumpy_sphere(3));
  ASSERT_EQ(run("spin a.stl -o one.ply --json one.json" + rho).code, 0);
  for (const int processes : {1, 2, 3, 7}) {
    ASSERT_EQ(run_on(processes, "a.stl -o all.ply" + rho).code, 0);
    const conformal::Surface_input one = conformal::read_surface_input(path("one.ply")),
                                   all = conformal::read_surface_input(path("all.ply"));
    EXPECT_EQ(all.mesh.corners(), one.mesh.corners());
    EXPECT_LT((all.mesh.positions() - one.mesh.positions()).colwise().norm().maxCoeff(),
              1e-8 * diagonal(one.mesh.positions()));
    const conformal::Property* const expected = find_numbers(one.file.faces, "attribute");
    const conformal::Property* const found = find_numbers(all.file.faces, "attribute");
    ASSERT_TRUE(expected != nullptr && found != nullptr);
    for (std::size_t f = 0; f < found->rows(); ++f) EXPECT_EQ(found->value(f), expected->value(f));
  }
}

TEST_F(Surfaces_in_parts, refuse_stl_files_that_are_none)
{
  const Mesh_view sphere = icosphere(2);
  const auto is_refused = [&](const std::string& words) {
    return fails(run_on(2, "a.stl -o b.ply" + rho), 4, words);
  };
  auto corners = sphere.corners();
  corners.back()[1] = corners.back()[0];
  write_stl("a.stl", {sphere.positions(), corners});
  EXPECT_TRUE(is_refused("has two equal corners"));
  Points infinite = sphere.positions();
  infinite(1, 7) = std::numeric_limits<double>::infinity();
  write_stl("a.stl", {infinite, sphere.corners()});
  EXPECT_TRUE(is_refused("not finite at facet"));
  write("a.stl", "solid\nendsolid\n");
  EXPECT_TRUE(is_refused("neither binary PLY nor binary STL"));
  EXPECT_FALSE(has("b.ply"));
}

// The square of rho is beyond numbers near the top: only some processes meet that.
TEST_F(Surfaces_in_parts, refuse_matrices_that_are_not_positive_definite)
{
  for (const Mesh_view& surface : {bumpy_sphere(3), disk(12)}) {
    write_ply("a.ply", surface);
    for (const int processes : {1, 2, 3}) {
      const std::string steep = "a.ply -o b.ply --max-scale none --rho-expression 'exp(900*x)'";
      EXPECT_TRUE(fails(run_on(processes, steep), 1, "not positive definite")) << processes;
    }
  }
  EXPECT_FALSE(has("b.ply"));
}

}  // namespace cgp_test::spin_in_parts_tests
