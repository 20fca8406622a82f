// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "editing_options.h"

#include "option_groups.h"

namespace conformal {

void add_fit_options(CLI::App& command, Fit_options& fit)
{
  command.add_option("source", fit.spin.input, "mesh file, - for standard input")->required();
  command.add_option("target", fit.target, "the deformed mesh, with the same faces")->required();
  command
      .add_option("--blend", fit.blend,
                  "t in (1 - t) lambda + t mu, 0 for conformal, 1 for nearest to the target")
      ->check(finite)
      ->capture_default_str();
  command
      .add_option("--scale-expression", fit.scale,
                  "multiplies the scales |mu|^2 of the target that are blended in (a conformal "
                  "surface has its own) by a formula above 0 in x y z (normalised frame) and nx ny "
                  "nz (outward normal)")
      ->check(formula)
      ->needs("--blend");
  const auto choose = [&fit](const std::string& word) {
    fit.boundary = word == "tangents" ? Boundary_choice::tangents : Boundary_choice::binormals;
  };
  command
      .add_option_function<std::string>("--boundary", choose,
                                        "which directions the boundary takes from the target")
      ->check(CLI::IsMember({"tangents", "binormals"}))
      ->default_str("tangents");
  add_mollification(command, fit.spin.mollification);
  command.add_option("--lambda", fit.spin.lambda,
                     "write the quaternions lambda as vertex properties NAME_w to NAME_z");
}

void add_blend_options(CLI::App& command, Blend_options& blend)
{
  command.add_option("a", blend.spin.input, "mesh file, - for standard input")->required();
  command.add_option("b", blend.other, "mesh file with the same faces")->required();
  command
      .add_option("--t", blend.t,
                  "how much of the difference is added: 0 for A, 1 for B, 2 for twice as far, "
                  "-1 for as far the other way")
      ->check(finite)
      ->capture_default_str();
  command
      .add_option("--onto", blend.onto,
                  "the mesh to which the difference is added, with the same faces (default: A)")
      ->check(not_empty);
  command
      .add_option("--frames", blend.frames,
                  "write so many surfaces on the way, OUTPUT with the number of the frame: "
                  "bear_0000.ply is at --from, the last at --t")
      ->check(CLI::Range(2, 9999));
  command.add_option("--from", blend.from, "t of the first frame")
      ->check(finite)
      ->needs("--frames")
      ->capture_default_str();
  add_solver(command, blend.spin);
}

}  // namespace conformal
