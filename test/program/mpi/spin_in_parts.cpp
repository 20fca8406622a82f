// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests examples/conformal/mpi/spin_in_parts.cpp examples/conformal/mpi/Distributed_spin.cpp
// Tests examples/conformal/mpi/Distributed_mesh.cpp examples/conformal/mpi/Ply_ranges.cpp
// Tests examples/conformal/mpi/Distributed_eigenvector.cpp examples/conformal/mpi/collective.cpp
// Tests examples/conformal/mpi/free_boundary.cpp examples/conformal/mpi/Counted_faces.cpp
// Tests examples/conformal/mpi/Distributed_matrix.h examples/conformal/mpi/Checkpoint.cpp
// Tests examples/conformal/mpi/Common_file.h examples/conformal/mpi/Border_vertices.cpp
// Tests examples/conformal/mpi/Distributed_cholesky.h examples/conformal/mpi/Distributed_solver.h
#include "program/mpi/spin_in_parts.h"
#include "support/bounded_meshes.h"
#include "support/limbs.h"
#include "support/random.h"
#include "support/spheres.h"
#include "support/tori.h"

#include <fstream>
#include <numeric>

namespace cgp_test::spin_in_parts_tests {

TEST_F(Spin_in_parts, gives_the_surface_of_one_process_without_a_bound)
{
  for (const Mesh_view& surface : {perturbed(bumpy_sphere(3), .02), dumbbell(3)}) {
    write_ply("a.ply", surface);
    ASSERT_EQ(run("spin a.ply -o one.ply --json one.json" + rho).code, 0);
    for (const int processes : {1, 2, 3, 4, 7}) expect_same(processes, rho, 1e-8);
    expect_same(3, multigrid, 1e-8);
  }
}

// A factor is exact, however many have a part of it.
TEST_F(Spin_in_parts, takes_as_many_iterations_on_any_number_of_processes)
{
  write_ply("a.ply", perturbed(bumpy_sphere(3), .02));
  std::vector<int> iterations;
  for (const int processes : {1, 2, 5}) {
    ASSERT_EQ(run_on(processes, "a.ply -o b.ply --json b.json" + rho).code, 0);
    const auto told = json("b.json");
    EXPECT_EQ(told["processes"]["solver"], "factor");
    EXPECT_EQ(told["processes"]["border_vertices"] == 0, processes == 1);
    iterations.push_back(told["iterations"]);
  }
  for (const int n : iterations) EXPECT_NEAR(n, iterations[0], .25 * iterations[0]);
}

TEST_F(Spin_in_parts, gives_the_disk_of_one_process)
{
  const Mesh_view flat = disk(12);
  Points p = flat.positions();
  for (Eigen::Index v = 0; v < p.cols(); ++v) p(2, v) = .4 * std::sin(2 * p(0, v) + p(1, v));
  write_ply("a.ply", perturbed({p, flat.corners()}, .01));
  ASSERT_EQ(run("spin a.ply -o one.ply --json one.json" + rho).code, 0);
  for (const int processes : {1, 2, 3, 4, 7}) expect_same(processes, rho, 1e-8);
  expect_same(3, multigrid, 1e-8);
}

// It shifts the eigenvalue, which the first prediction has to know.
TEST_F(Spin_in_parts, is_not_changed_by_a_constant)
{
  write_ply("a.ply", dumbbell(2));
  const std::string formula =
      "a.ply --max-scale none --advanced tolerance=1e-9 -q --rho-expression 'sin(3*y+1)";
  ASSERT_EQ(run_on(1, formula + "' -o b.ply --json b.json").code, 0);
  ASSERT_EQ(run_on(1, formula + "+3' -o c.ply --json c.json").code, 0);
  EXPECT_LT(difference("b.ply", "c.ply"), 1e-8);
  EXPECT_EQ(json("b.json")["iterations"], json("c.json")["iterations"]);
}

// Of others, a process has those along its border: some times the root of its own.
TEST_F(Spin_in_parts, divides_the_surface)
{
  const Mesh_view sphere = bumpy_sphere(4);
  write_ply("a.ply", sphere);
  ASSERT_EQ(run_on(3, "a.ply -o b.ply --json b.json" + rho).code, 0);
  const std::vector<double> own = json("b.json")["processes"]["vertices"],
                            others = json("b.json")["processes"]["other_vertices"];
  EXPECT_EQ(std::accumulate(own.begin(), own.end(), 0.), sphere.size_of_vertices());
  for (const double n : own) EXPECT_NEAR(n, sphere.size_of_vertices() / 3., 60);
  for (const double n : others) EXPECT_LT(n, 6 * std::sqrt(sphere.size_of_vertices() / 3.));
}

// Spins take 32 bytes for each vertex of the surface, positions 24. The first process gets what the
// others add along the borders, which is of the size of a part.
TEST_F(Spin_in_parts, gathers_nothing_of_the_size_of_the_surface)
{
  const Mesh_view sphere = bumpy_sphere(6);
  write_ply("a.ply", sphere);
  const auto received_at_once = [&](int processes) {
    const std::string program =
        " env ASAN_OPTIONS=verify_asan_link_order=0 LD_PRELOAD=" CGP_MPI_TRAFFIC " " CGP_MPI_PROGRAM
        " spin a.ply -o b.ply ";
    EXPECT_EQ(shell(mpi(processes) + program + rho).code, 0);
    Eigen::VectorXd bytes = Eigen::VectorXd::Constant(processes, 1e30);
    for (int p = 0; p < processes; ++p)
      std::ifstream(path("traffic." + std::to_string(p))) >> bytes[p];
    return Eigen::VectorXd(bytes / sphere.size_of_vertices());
  };
  EXPECT_GT(received_at_once(2).minCoeff(), 40);  // the graph of half of the surface
  const Eigen::VectorXd eight = received_at_once(8);
  EXPECT_LT(eight.tail(7).maxCoeff(), 16);
  EXPECT_LT(eight[0], 30);
}

TEST_F(Spin_in_parts, carries_other_properties_over_and_says_what_not)
{
  const Mesh_view sphere = perturbed(bumpy_sphere(2), .02);
  write_ply("a.ply", sphere);
  const std::string quiet = rho.substr(0, rho.find("-q")) + "--max-scale none";
  const Program_run r = run_on(2, "a.ply -o b.ply" + quiet);
  ASSERT_EQ(r.code, 0);
  EXPECT_NE(r.err.find("left out: normals"), std::string::npos) << r.err;
  const conformal::Surface_file file = conformal::read_surface_input(path("b.ply")).file;
  const conformal::Property* const names = find_numbers(file.vertices, "name");
  ASSERT_NE(names, nullptr);
  for (std::size_t v = 0; v < names->rows(); ++v) EXPECT_EQ(names->value(v), double(v));
  const conformal::Property* const colours = find_numbers(file.faces, "colour");
  ASSERT_NE(colours, nullptr);
  for (std::size_t f = 0; f < colours->rows(); ++f) EXPECT_EQ(colours->value(f), double(f % 7));
  EXPECT_EQ(find_numbers(file.vertices, "nx"), nullptr);
  EXPECT_NE(find_numbers(file.vertices, "quality"), nullptr);
  EXPECT_NE(find_numbers(file.vertices, "rho"), nullptr);
}

TEST_F(Spin_in_parts, refuses_what_it_cannot_divide)
{
  const auto is_refused = [&](const Mesh_view& surface, const std::string& words) {
    write_ply("a.ply", surface);
    const Program_run r = run_on(2, "a.ply -o b.ply" + rho);
    return fails(r, 4, words);
  };
  EXPECT_TRUE(is_refused(btorus(12), "handles or holes"));
  EXPECT_TRUE(is_refused(annulus(.5, 1, 24, 5), "handles or holes"));
  const Mesh_view sphere = icosphere(2);
  Points two(3, 2 * sphere.size_of_vertices());
  two << sphere.positions(), sphere.positions().colwise() + Eigen::Vector3d(5, 0, 0);
  auto corners = sphere.corners();
  for (const auto& v : sphere.corners())
    corners.push_back({v[0] + sphere.size_of_vertices(), v[1] + sphere.size_of_vertices(),
                       v[2] + sphere.size_of_vertices()});
  EXPECT_TRUE(is_refused({two, corners}, "several components"));
  Points infinite = sphere.positions();
  infinite(1, 7) = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(is_refused({infinite, sphere.corners()}, "vertex 7"));
  write("text.ply", "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nend_header\n");
  EXPECT_TRUE(fails(run_on(2, "text.ply -o b.ply" + rho), 4, "not binary"));
  EXPECT_TRUE(fails(run_on(2, "absent.ply -o b.ply" + rho), 3, "absent.ply"));
  EXPECT_FALSE(has("b.ply"));
}

TEST_F(Spin_in_parts, is_resumed_where_it_was_ended)
{
  write_ply("a.ply", dumbbell(2));
  const std::string all = "a.ply -o all.ply --json all.json" + rho;
  ASSERT_EQ(run_on(2, all).code, 0);
  const int iterations = json("all.json")["iterations"];
  const std::string part = "a.ply -o b.ply --json b.json --advanced checkpoint=0" + rho;
  const std::string few = " --advanced iterations=" + std::to_string(iterations * 2 / 3);
  EXPECT_TRUE(fails(run_on(2, part + few), 1, "did not converge"));
  EXPECT_TRUE(has("b.ply.checkpoint"));
  EXPECT_FALSE(has("b.ply"));
  EXPECT_TRUE(fails(run_on(2, part + "--amplitude 2 --resume"), 4, "of another run"));
  ASSERT_EQ(run_on(3, part + "--resume").code, 0);
  EXPECT_LT(int(json("b.json")["iterations"]), iterations * 2 / 3);
  EXPECT_LT(difference("all.ply", "b.ply"), 1e-8);
  EXPECT_FALSE(has("b.ply.checkpoint"));
  EXPECT_TRUE(fails(run_on(2, part + "--resume"), 3, "no checkpoint"));
}

// As where a machine is lost or has no memory left
TEST_F(Spin_in_parts, ends_where_a_process_is_killed_and_can_be_resumed)
{
  write_ply("a.ply", dumbbell(2));
  const std::string arguments = "a.ply --json all.json" + multigrid;  // not done at once
  ASSERT_EQ(run_on(3, arguments + "-o all.ply").code, 0);
  const int iterations = json("all.json")["iterations"];
  for (const int killed : {0, 2}) {
    kill(3, killed, arguments, "b.ply", "numbers");
    ASSERT_EQ(run_on(3, "a.ply --json b.json --resume -o b.ply" + multigrid).code, 0);
    EXPECT_LT(int(json("b.json")["iterations"]), iterations);
    EXPECT_LT(difference("all.ply", "b.ply"), 1e-8);
    EXPECT_EQ(shell("rm b.ply").code, 0);
  }
}

TEST_F(Spin_in_parts, writes_what_does_not_verify_only_by_force)
{
  write_ply("a.ply", bumpy_sphere(3));
  const std::string limit = "a.ply -o b.ply --limit quasi_conformal=1.0001" + rho;
  EXPECT_TRUE(fails(run_on(2, limit), 1, "the mean quasi-conformal error is 1."));
  EXPECT_FALSE(has("b.ply"));
  EXPECT_FALSE(has("b.ply.part"));
  EXPECT_EQ(run_on(2, limit + "--force").code, 0);
  EXPECT_TRUE(has("b.ply"));
}

}  // namespace cgp_test::spin_in_parts_tests
