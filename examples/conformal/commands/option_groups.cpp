// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "option_groups.h"

#include "conformal/transform/solve_spin.h"

#include <cmath>
#include <cstdlib>

namespace conformal {

void add_common(CLI::App& command, Common_options& common)
{
  command
      .add_option("--json", common.json,
                  "write the report to this file, or to /dev/stdout for a pipe")
      ->check(file_name);
  command.add_option("--threads", common.threads, "threads of the linear algebra")
      ->check(above_zero)
      ->capture_default_str();
  command.add_flag("-q,--quiet", common.quiet, "print nothing but errors");
  CLI::App& seldom = advanced(command);
  seldom
      .add_option("--max-memory", common.max_memory,
                  "GiB that the work may take, at least 0.1 (default: half of what the machine or "
                  "the container has)")
      ->check(CLI::Range(.1, 1e6));
  add_choice(seldom, "--progress", common.progress, {"auto", "none", "json"},
             "of long work, on stderr: auto shows it on a terminal, and elsewhere writes a line "
             "every ten seconds, unless --quiet; json writes an object per line, for programs");
  seldom.add_flag("--strict", common.strict, "refuse what would be repaired with a note");
}

void add_input(CLI::App& command, std::string& input)
{
  command.add_option("input", input, "mesh file, - for standard input")->required();
}

void add_repair(CLI::App& command, Common_options& common)
{
  command.add_flag(
      "--repair", common.repair,
      "first merge coincident points, remove degenerate and repeated faces, mend those "
      "of area zero, and cut where the surface is not a manifold; new numbers are in the "
      "JSON report");
}

CLI::Option* add_output(CLI::App& command, Common_options& common, const char* what)
{
  return command.add_option("-o,--output", common.output, what)->check(file_name);
}

CLI::Option* add_mesh_output(CLI::App& command, Common_options& common, const char* what)
{
  advanced(command).add_flag("--ascii", common.ascii, "write PLY as text");
  advanced(command).add_flag(
      "--float", common.is_single,
      "write the coordinates of PLY in single precision, which some programs want");
  return add_output(command, common, what);
}

void add_html(CLI::App& command, Common_options& common)
{
  command
      .add_option("--html", common.html,
                  "write a page that shows both shapes, the error of each face and the report; "
                  "it opens in a browser without a network")
      ->check(file_name);
}

void add_components(CLI::App& command, Common_options& common)
{
  CLI::Option* each = command.add_flag(
      "--each-component", common.each_component,
      "take a surface of several components, and work on each as if it were alone");
  advanced(command)
      .add_flag("--keep-going", common.keep_going,
                "where some of them fail, write the others, and those as they were; the exit code "
                "is 1 all the same")
      ->needs(each);
}

void add_transformation(CLI::App& command, Common_options& common)
{
  add_repair(command, common);
  add_components(command, common);
  add_mesh_output(command, common)->required();
  add_html(command, common);
}

CLI::Option_group* add_rho(CLI::App& command, Rho_options& rho)
{
  auto* source = command.add_option_group("rho", "the change of mean curvature, one of");
  source
      ->add_option("--rho-expression", rho.expression,
                   "formula in x y z (normalised frame), nx ny nz (outward normal), pi, e; "
                   "sin exp abs min ... gauss(d,s) bump(d,r)")
      ->check(formula);
  source->add_option("--rho-property", rho.property, "vertex or face property of the mesh")
      ->check(not_empty);
  source
      ->add_option("--rho-file", rho.file,
                   "text file, a number per vertex or face, in 1/length of the "
                   "normalised frame; # begins a comment")
      ->check(not_empty);
  source
      ->add_option("--paint,--rho-image", rho.image,
                   "picture (PNG, JPEG, PGM, PPM): rho = gray - 0.5, gray from 0 to 1")
      ->check(not_empty);
  add_choice(command, "--projection", rho.projection, {"uv", "x", "y", "z", "sphere"},
             "of the picture: uv, along an axis (x, y, z), or sphere around the z axis");
  command.add_option("--amplitude", rho.amplitude, "multiplies rho")
      ->check(finite)
      ->capture_default_str();
  const auto set_on = [&rho](const std::string& word) { rho.on_faces = word == "faces"; };
  command
      .add_option_function<std::string>("--on", set_on,
                                        "where rho has its values (default: vertices)")
      ->check(CLI::IsMember({"vertices", "faces"}));
  return source;
}

void add_filter(CLI::App& command, Filter_request& filter)
{
  add_choice(command, "--filter", filter.choice, {"none", "low-pass", "high-pass", "unsharp"},
             "keeps the large features of rho, the small ones, or lifts the small ones out");
  const auto set_on = [&filter](const std::string& word) { filter.on_image = word == "image"; };
  advanced(command)
      .add_option_function<std::string>("--filter-on", set_on,
                                        "the picture before it is painted, or rho on the surface "
                                        "(default: the picture, if there is one)")
      ->check(CLI::IsMember({"image", "surface"}));
  command
      .add_option("--filter-radius", filter.radius,
                  "on a picture, the standard deviation of the Gauss function in pixels "
                  "(default: 6)")
      ->check(above_zero);
  command
      .add_option("--filter-weight", filter.weight,
                  "on the surface, features larger than this to the power 1/(2 order), in radii of "
                  "the sphere of the same area, are large (default: 0.01)")
      ->check(above_zero);
  advanced(command)
      .add_option("--filter-order", filter.order,
                  "on the surface, the sharpness of the filter, 0 to 3 (default: 1)")
      ->check(CLI::Range(0, 3));
  advanced(command)
      .add_option("--filter-amount", filter.amount,
                  "how often the unsharp mask adds the small features (default: 1)")
      ->check(finite);
  CLI::Option* const kind = command.get_option("--filter");
  for (const char* const detail : {"--filter-radius", "--filter-weight"})
    command.get_option(detail)->needs(kind);
  for (const char* const detail : {"--filter-on", "--filter-order", "--filter-amount"})
    advanced(command).get_option(detail)->needs(kind);
}

void add_lambda(CLI::App& command, std::string& lambda)
{
  command
      .add_option("--lambda", lambda,
                  "write the quaternions lambda as vertex properties NAME_w to NAME_z")
      ->check(property_name);
}

void add_solver(CLI::App& command, CGP::Spin_solvers& solvers)
{
  advanced(command)
      .add_option_function<std::string>(
          "--solver", [&solvers](const std::string& name) { solvers = solvers_named(name); },
          "native, cholmod (where it was built in) or eigen")
      ->check(CLI::IsMember({"native", "cholmod", "eigen"}))
      ->default_str("native");
}

CLI::Option* add_mollification(CLI::App& command, std::optional<double>& mollification,
                               const std::string& otherwise)
{
  const std::string description =
      std::string(
          "take thin faces as they are, also those of area zero: solve on the intrinsic Delaunay "
          "triangulation, and add to all edges what triangles lack, at most this share of the mean "
          "edge (--mollify=0.001; default 1e-6); the report tells how many edges were flipped and "
          "by "
          "how much they were made longer") +
      otherwise;
  return command.add_flag("--mollify{1e-6}", description)
      ->check(below_one)
      ->each([&mollification](const std::string& text) {
        const double share = std::strtod(text.c_str(), nullptr);
        mollification = share > 0 ? std::optional(share) : std::nullopt;
      });
}

void add_boundary(CLI::App& command, CGP::Boundary_condition& boundary)
{
  const auto choose = [&boundary](const std::string& word) {
    boundary = word == "tangents"    ? CGP::Boundary_condition::tangents()
               : word == "binormals" ? CGP::Boundary_condition::binormals()
                                     : CGP::Boundary_condition::free();
  };
  command
      .add_option_function<std::string>(
          "--boundary", choose,
          "what its boundary keeps: nothing (it moves as little as it can), its tangents, or its "
          "binormals, which point out of the surface")
      ->check(CLI::IsMember({"free", "tangents", "binormals"}))
      ->default_str("free");
}

void add_distance_tolerance(CLI::App& command, double& tolerance)
{
  advanced(command)
      .add_option("--distance-tolerance", tolerance,
                  "the search ends at this distance from the target, relative to its diagonal, and "
                  "a hundred times as many radians between normals")
      ->check(finite)
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
}

void add_period_defect(CLI::App& command, std::optional<double>& max_period_defect)
{
  limit(command)
      .add_option("--period_defect", max_period_defect,
                  "largest part of the edges that may fail to close up around handles and holes; "
                  "by default a quarter of the discretisation error")
      ->check(above_zero);
}

void add_map_limits(CLI::App& command, CGP::Spin_report::Limits& limits, bool& force)
{
  CLI::App& bounds = limit(command);
  bounds
      .add_option("--quasi_conformal", limits.map.quasi_conformal,
                  "largest mean quasi-conformal error, over the old and over the new area")
      ->check(above_zero)
      ->capture_default_str();
  bounds.add_option("--flipped_share", limits.map.flipped_share, "largest share of flipped faces")
      ->check(finite)
      ->capture_default_str();
  bounds
      .add_option("--collapsed_share", limits.map.collapsed_share,
                  "largest share of the area whose lengths may shrink below a tenth of the mean")
      ->check(finite)
      ->capture_default_str();
  command.add_flag("--force", force, "write also what does not verify");
}

void add_limits(CLI::App& command, CGP::Spin_report::Limits& limits, bool& force)
{
  CLI::App& bounds = limit(command);
  bounds.add_option("--closure", limits.closure, "largest closure residual")
      ->check(above_zero)
      ->capture_default_str();
  bounds
      .add_option_function<double>(
          "--direction_error",
          [&limits](double degrees) { limits.direction_error = degrees * std::acos(-1.) / 180; },
          "by how many degrees directions at a boundary may be missed in the mean")
      ->check(above_zero)
      ->default_str("10");
  bounds
      .add_option("--gamma_radius", limits.gamma_radius,
                  "largest modulus of the constant that prescribed binormals add to rho, times the "
                  "radius of the disk of the same area; 2 for the sphere of this area")
      ->check(above_zero)
      ->capture_default_str();
  bounds
      .add_option("--realised_share", limits.realised_share,
                  "smallest share of the norm of rho, where handles or holes do not allow all")
      ->check(finite)
      ->capture_default_str();
  bounds
      .add_option("--kept_norm", limits.kept_norm, "likewise, where the bound on lengths does not")
      ->check(finite)
      ->capture_default_str();
  add_map_limits(command, limits, force);
}

}  // namespace conformal
