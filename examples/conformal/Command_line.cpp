// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Command_line.h"

#include "Failure.h"
#include "versions.h"

#include <CLI/CLI.hpp>

#include <cmath>

namespace conformal {
namespace {

const char* const about =
    "Edits, compares and describes surfaces by their curvature, without shearing them.\n"
    "Reads OFF, OBJ, PLY and STL; writes PLY, OFF, OBJ or GLB, by the extension of the output.\n"
    "Vertices and faces keep their order and their properties; numbers in messages count from 0.\n"
    "Example: conformal spin bear.off --rho-expression '1.5*sin(5*y)' -o bear_spin.ply\n"
    "Exit codes: 0 done, 1 failed or not verified, 2 usage, 3 cannot read, 4 input unsuitable,\n"
    "5 cannot write, 6 out of memory, 130 interrupted, 143 terminated.";

const char* const about_info =
    "Tells what a mesh is: counts, topology, orientation, shape of its triangles, energies, and\n"
    "all that keeps it from being transformed.\n"
    "Example: conformal info bear.off --json bear.json";

const char* const about_spin =
    "Deforms a closed surface conformally so that its mean curvature changes by rho.\n"
    "rho is in 1/length of the normalised frame (the middle of the bounding box at 0, its "
    "diagonal\n"
    "2), positive rho bulges outward, constants have no effect. The output has the vertex\n"
    "properties quality (quasi-conformal error, 1 is perfect) and rho; normals are left out.\n"
    "A result that does not verify is not written, and the exit code is 1.\n"
    "Example: conformal spin bear.off --rho-expression '1.5*sin(5*y)' -o bear_spin.ply";

const char* const about_compare =
    "Measures the map between two meshes with the same faces: angles, lengths, flips, energies.\n"
    "-o writes the second one with the vertex property quality (quasi-conformal error).\n"
    "Example: conformal compare bear.off bear_spin.ply --json map.json";

std::string above_zero(const std::string& text)
{
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return *end == 0 && value > 0 && std::isfinite(value) ? "" : "wanted a number above 0";
}

std::string finite(const std::string& text)
{
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return *end == 0 && std::isfinite(value) ? "" : "wanted a finite number";
}

class Parser {
 public:
  Parser() : m_app(about, "conformal")
  {
    m_app.require_subcommand(1);
    m_app.set_version_flag("--version", versions);
    add_info();
    add_spin();
    add_compare();
  }

  Command_line parse(int argc, const char* const* argv)
  {
    try {
      m_app.parse(argc, argv);
    } catch (const CLI::CallForVersion& answer) {
      return answered(answer.what());
    } catch (const CLI::CallForHelp&) {
      return answered(m_app.help());
    } catch (const CLI::ParseError& error) {
      throw Failure(Exit_code::usage, std::string(error.what()) + "; try: " + help_command());
    }
    return chosen();
  }

 private:
  CLI::App* add_command(const char* name, const char* description)
  {
    CLI::App* command = m_app.add_subcommand(name, description);
    command->add_option("--json", m_common.json, "write the report to this file");
    command->add_option("--threads", m_common.threads, "threads of the linear algebra")
        ->check(above_zero)
        ->capture_default_str();
    command->add_flag("-q,--quiet", m_common.quiet, "print nothing but errors");
    command->add_flag("--strict", m_common.strict, "refuse what would be repaired with a note");
    return command;
  }

  void add_info()
  {
    CLI::App* command = add_command("info", about_info);
    command->add_option("input", m_info.input, "mesh file, - for standard input")->required();
  }

  void add_spin()
  {
    CLI::App* command = add_command("spin", about_spin);
    command->add_option("input", m_spin.input, "mesh file, - for standard input")->required();
    command->add_option("-o,--output", m_common.output, "where the result goes")->required();
    add_rho(*command);
    command->add_option("--lambda", m_spin.lambda,
                        "write the quaternions lambda as vertex properties NAME_w to NAME_z");
    command
        ->add_option("--problem", m_problem,
                     "standard, or generalized for rho on faces where that can be trusted")
        ->check(CLI::IsMember({"standard", "generalized"}))
        ->capture_default_str();
    command->add_option("--solver", m_solver, "cholmod (where it was built in) or eigen")
        ->check(CLI::IsMember({"cholmod", "eigen"}));
    command->add_option("--seed", m_common.seed, "of random start vectors")->capture_default_str();
    command->add_option("--tolerance", m_common.tolerance, "of the eigenvector")
        ->check(above_zero)
        ->capture_default_str();
    add_limits(*command);
  }

  void add_rho(CLI::App& command)
  {
    auto* source = command.add_option_group("rho", "the change of mean curvature, one of");
    source->add_option("--rho-expression", m_spin.rho.expression,
                       "formula in x y z (normalised frame), nx ny nz (outward normal), pi, e; "
                       "sin exp abs min ... gauss(d,s) bump(d,r)");
    source->add_option("--rho-property", m_spin.rho.property,
                       "vertex or face property of the mesh");
    source->add_option("--rho-file", m_spin.rho.file,
                       "text file, a number per vertex or face; # begins a comment");
    source->add_option("--rho-image", m_spin.rho.image,
                       "picture (PNG, JPEG, PGM, PPM): rho = gray - 0.5, gray from 0 to 1");
    source->require_option(1);
    command
        .add_option("--projection", m_spin.rho.projection,
                    "of the picture: uv, along an axis (x, y, z), or sphere around the z axis")
        ->transform(CLI::CheckedTransformer(
            std::vector<std::pair<std::string, Projection>>{{"uv", Projection::uv},
                                                            {"x", Projection::x},
                                                            {"y", Projection::y},
                                                            {"z", Projection::z},
                                                            {"sphere", Projection::sphere}}));
    command.add_option("--amplitude", m_spin.rho.amplitude, "multiplies rho")
        ->check(finite)
        ->capture_default_str();
    command.add_option("--on", m_on, "where rho has its values (default: vertices)")
        ->check(CLI::IsMember({"vertices", "faces"}));
  }

  void add_limits(CLI::App& command)
  {
    command.add_option("--max-closure", m_spin.limits.closure, "largest closure residual")
        ->check(above_zero)
        ->capture_default_str();
    command
        .add_option("--max-quasi-conformal", m_spin.limits.quasi_conformal,
                    "largest mean quasi-conformal error")
        ->check(above_zero)
        ->capture_default_str();
    command.add_option("--max-flipped", m_spin.limits.flipped, "largest share of flipped faces")
        ->check(finite)
        ->capture_default_str();
    command.add_flag("--force", m_spin.force, "write also what does not verify");
  }

  void add_compare()
  {
    CLI::App* command = add_command("compare", about_compare);
    command->add_option("before", m_compare.before, "mesh file")->required();
    command->add_option("after", m_compare.after, "mesh file with the same faces")->required();
    command->add_option("-o,--output", m_common.output, "the second mesh, with quality");
  }

  std::string help_command() const
  {
    for (const CLI::App* command : m_app.get_subcommands())
      return "conformal " + command->get_name() + " --help";
    return "conformal --help";
  }

  static Command_line answered(std::string answer)
  {
    Command_line line;
    line.answer = std::move(answer);
    if (line.answer.empty() || line.answer.back() != '\n') line.answer += '\n';
    return line;
  }

  Command_line chosen()
  {
    Command_line line{m_common, m_app.get_subcommands().front()->get_name(), {}, {}};
    if (line.command == "info") line.options = m_info;
    if (line.command == "compare") line.options = m_compare;
    if (line.command != "spin") return line;
    if (!m_on.empty()) m_spin.rho.on_faces = m_on == "faces";
    m_spin.generalized = m_problem == "generalized";
    m_spin.eigen_solver = m_solver == "eigen";
#ifndef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
    if (m_solver == "cholmod")
      throw Failure(Exit_code::usage,
                    "this program was built without CHOLMOD; try: --solver eigen");
#endif
    line.options = m_spin;
    return line;
  }

  Common_options m_common;
  Info_options m_info;
  Spin_options m_spin;
  Compare_options m_compare;
  std::string m_on, m_problem = "standard", m_solver;
  CLI::App m_app;
};

}  // namespace

Command_line parse_command_line(int argc, const char* const* argv)
{
  return Parser().parse(argc, argv);
}

}  // namespace conformal
