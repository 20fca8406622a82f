// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/input/Surface_input.h"
#include "program/support.h"
#include "support/mesh_tools.h"

#include <nlohmann/json.hpp>

#include <string>

/// What tests of `conformal-mpi spin` share.
namespace cgp_test::spin_in_parts_tests {

using namespace program_test;

inline const std::string wanted_rho =
    " --rho-expression '1.5*sin(3*y+1)*cos(2*x)' --advanced tolerance=1e-9 -q ";
inline const std::string rho = wanted_rho + "--max-scale none ";
inline const std::string multigrid = rho + "--advanced solver=multigrid ";

inline double diagonal(const Points& p)
{
  return (p.rowwise().maxCoeff() - p.rowwise().minCoeff()).norm();
}

class Spin_in_parts : public Program {
 protected:
  /// on so many processes
  Program_run run_on(int processes, const std::string& arguments) const
  {
    return shell(mpi(processes) + " " CGP_MPI_PROGRAM " spin " + arguments);
  }

  static std::string mpi(int processes)
  {
    return "OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
           "OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_mpi_yield_when_idle=1 " CGP_MPI_RUN " " +
           std::to_string(processes);
  }

  /// \brief kills one of so many processes when the checkpoint has some text: the others must not
  /// wait for ever, and there is no output.
  /// \param output whose checkpoint it is, without further options
  void kill(int processes, int rank, const std::string& arguments, const std::string& output,
            const std::string& text) const
  {
    const std::string killed = "kill -9 $(cat process." + std::to_string(rank) + ")";
    const Program_run r =
        shell(mpi(processes) + " sh -c 'echo $$ >process.$OMPI_COMM_WORLD_RANK; exec " +
              CGP_MPI_PROGRAM + " spin \"$@\"' sh " + arguments + " -o " + output +
              " --advanced checkpoint=0 & all=$!; until grep -qas '" + text + "' " + output +
              ".checkpoint; do kill -0 $all || exit 99; done; " + killed + "; wait $all");
    EXPECT_NE(r.code, 0);
    EXPECT_NE(r.code, 99) << "too fast to be killed";
    EXPECT_NE(r.err, "");
    const std::string other = "process." + std::to_string(rank == 0 ? 1 : 0);
    EXPECT_EQ(shell("for i in $(seq 600); do kill -0 $(cat " + other +
                    ") || exit 0; sleep .1; done; exit 1")
                  .code,
              0);
    EXPECT_FALSE(has(output));
    EXPECT_FALSE(has(output + ".part"));
  }

  /// the largest distance between two vertices of files, by the diagonal
  double difference(const std::string& a, const std::string& b) const
  {
    const Points p = mesh(a).positions(), q = mesh(b).positions();
    return (p - q).colwise().norm().maxCoeff() / diagonal(p);
  }

  /// whether the program on so many processes has the surface and the numbers of one.json
  void expect_same(int processes, const std::string& arguments, double tolerance) const
  {
    const Program_run r = run_on(processes, "a.ply -o all.ply --json all.json " + arguments);
    ASSERT_EQ(r.code, 0) << r.err;
    const Points expected = mesh("one.ply").positions();
    EXPECT_LT((mesh("all.ply").positions() - expected).colwise().norm().maxCoeff(),
              tolerance * diagonal(expected))
        << processes;
    EXPECT_EQ(mesh("all.ply").corners(), mesh("one.ply").corners());
    const auto one = json("one.json"), all = json("all.json");
    for (const char* const name : {"eigenvalue", "overlap", "closure_residual", "min_spin_ratio"})
      EXPECT_NEAR(all[name], one[name], 1e-7) << name;
    for (const char* const name : {"mean", "p99", "max", "mean_over_new_area"})
      EXPECT_NEAR(all["quasi_conformal"][name], one["quasi_conformal"][name], 1e-6) << name;
    for (const char* const name : {"rms", "max"})
      EXPECT_NEAR(all["length_cross_ratio"][name], one["length_cross_ratio"][name], 1e-6);
    for (const char* const name : {"share", "correlation", "wrong_sign", "seen_share"})
      EXPECT_NEAR(all["realised_curvature"][name], one["realised_curvature"][name], 1e-6) << name;
    for (const char* const name : {"min", "max", "collapsed_share"})
      EXPECT_NEAR(all["scale"][name], one["scale"][name], 1e-6) << name;
  }

  /// a binary PLY with one more property
  void write_ply(const std::string& name, const Mesh_view& mesh) const
  {
    std::string text =
        "ply\nformat binary_little_endian 1.0\nelement vertex " +
        std::to_string(mesh.size_of_vertices()) +
        "\nproperty float nx\nproperty double x\nproperty double y\nproperty double "
        "z\nproperty short name\nelement face " +
        std::to_string(mesh.size_of_faces()) +
        "\nproperty uchar colour\nproperty list uchar int vertex_indices\nend_header\n";
    const auto append = [&](const auto& value) {
      text.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    for (int v = 0; v < mesh.size_of_vertices(); ++v) {
      append(1.f);
      for (Eigen::Index c = 0; c < 3; ++c) append(mesh.position(v)[c]);
      append(static_cast<short>(v));
    }
    for (int f = 0; f < mesh.size_of_faces(); ++f) {
      append(static_cast<unsigned char>(f % 7));
      append(static_cast<unsigned char>(3));
      append(mesh.corners(f));
    }
    write(name, text);
  }

  Mesh_view mesh(const std::string& name) const
  {
    return conformal::read_surface_input(path(name)).mesh;
  }

  /// mpiexec adds words of its own
  static bool fails(const Program_run& run, int code, const std::string& words)
  {
    const std::size_t at = run.err.find("conformal: error: ");
    EXPECT_NE(run.err.find(words, at), std::string::npos) << run.err;
    return run.code == code && at != std::string::npos;
  }

  nlohmann::json json(const std::string& name) const { return read_json(name)["result"]; }
};

}  // namespace cgp_test::spin_in_parts_tests
