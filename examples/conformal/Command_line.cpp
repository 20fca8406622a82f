// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Command_line.h"

#include "Failure.h"
#include "help_texts.h"
#include "versions.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

namespace conformal {
namespace {

// in the order of Projection
const std::vector<std::string> projections = {"uv", "x", "y", "z", "sphere"};

// in the order of Balance_choice
const std::vector<std::string> balances = {"none", "initial", "canonical"};

int place_of(const std::string& word, const std::vector<std::string>& words)
{
  return static_cast<int>(std::find(words.begin(), words.end(), word) - words.begin());
}

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
    add_flow();
    add_harmonic();
    add_compare();
  }

  Command_line parse(int argc, const char* const* argv)
  {
    if (argc > 1) require_command(argv[1]);
    try {
      m_app.parse(argc, argv);
    } catch (const CLI::CallForVersion& answer) {
      return answered(answer.what());
    } catch (const CLI::CallForHelp&) {
      return answered(m_app.help());
    } catch (const CLI::ExtrasError&) {
      throw Failure(Exit_code::usage,
                    "unknown: " + unknown_argument() + "; try: " + help_command());
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
    command->add_flag("--open-handles", m_spin.open_handles,
                      "apply rho in one step, also the part of it that shears handles");
    command->add_option("--solver", m_solver, "native, cholmod (where it was built in) or eigen")
        ->check(CLI::IsMember({"native", "cholmod", "eigen"}))
        ->capture_default_str();
    add_eigenvector(*command);
    add_limits(*command, m_spin.limits, m_spin.force);
  }

  void add_flow()
  {
    CLI::App* command = add_command("flow", about_flow);
    command->add_option("input", m_flow.input, "mesh file, - for standard input")->required();
    command->add_option("-o,--output", m_common.output, "where the result goes")->required();
    command->add_option("--steps", m_flow.steps, "how many steps at most")
        ->check(above_zero)
        ->capture_default_str();
    command
        ->add_option("--time-step", m_flow.time_step,
                     "the largest; 1 goes furthest, 2 is the limit of stability")
        ->check(above_zero)
        ->check(CLI::Range(0., 2.))
        ->capture_default_str();
    command
        ->add_option("--filter-weight", m_flow.filter_weight,
                     "keeps the large features; detail finer than this to the power "
                     "1/(2 order), in radii of the sphere of the same area, is smoothed")
        ->check(above_zero);
    command->add_option("--filter-order", m_flow.filter_order, "sharpness of the filter, 0 to 3")
        ->check(CLI::Range(0, 3))
        ->needs("--filter-weight")
        ->capture_default_str();
    command
        ->add_option("--balance", m_balance,
                     "undoes drift by sphere inversions: towards the initial areas, or those of "
                     "the canonical metric (genus > 0)")
        ->check(CLI::IsMember(balances))
        ->capture_default_str();
    command
        ->add_option("--every", m_flow.every,
                     "write every so many steps a snapshot, OUTPUT with the number of the step: "
                     "bear_0005.ply")
        ->check(above_zero);
    add_eigenvector(*command);
    add_limits(*command, m_flow.limits, m_flow.force);
  }

  void add_eigenvector(CLI::App& command)
  {
    command.add_option("--seed", m_common.seed, "of random start vectors")->capture_default_str();
    command.add_option("--tolerance", m_common.tolerance, "of the eigenvector")
        ->check(above_zero)
        ->capture_default_str();
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
        .add_option("--projection", m_projection,
                    "of the picture: uv, along an axis (x, y, z), or sphere around the z axis")
        ->check(CLI::IsMember(projections))
        ->capture_default_str();
    command.add_option("--amplitude", m_spin.rho.amplitude, "multiplies rho")
        ->check(finite)
        ->capture_default_str();
    command.add_option("--on", m_on, "where rho has its values (default: vertices)")
        ->check(CLI::IsMember({"vertices", "faces"}));
  }

  static void add_limits(CLI::App& command, Verification_limits& limits, bool& force)
  {
    command.add_option("--max-closure", limits.closure, "largest closure residual")
        ->check(above_zero)
        ->capture_default_str();
    command
        .add_option("--max-quasi-conformal", limits.quasi_conformal,
                    "largest mean quasi-conformal error")
        ->check(above_zero)
        ->capture_default_str();
    command.add_option("--max-flipped", limits.flipped, "largest share of flipped faces")
        ->check(finite)
        ->capture_default_str();
    command.add_flag("--force", force, "write also what does not verify");
  }

  void add_harmonic()
  {
    CLI::App* command = add_command("harmonic", about_harmonic);
    command->add_option("input", m_harmonic.input, "mesh file, - for standard input")->required();
    command->add_option("-o,--output", m_common.output, "the mesh with the fields");
    command->add_option("--form", m_harmonic.form, "write only this one, counted from 0")
        ->check(CLI::NonNegativeNumber);
  }

  void add_compare()
  {
    CLI::App* command = add_command("compare", about_compare);
    command->add_option("before", m_compare.before, "mesh file")->required();
    command->add_option("after", m_compare.after, "mesh file with the same faces")->required();
    command->add_option("-o,--output", m_common.output, "the second mesh, with quality");
  }

  void require_command(const std::string& name) const
  {
    if (name.empty() || name[0] == '-') return;
    const auto has_name = [&](const CLI::App* command) { return command->get_name() == name; };
    if (m_app.get_subcommands(has_name).empty())
      throw Failure(Exit_code::usage, "unknown command '" + name +
                                          "'; try: info, spin, flow, harmonic, compare or --help");
  }

  // Of `--wrong 3 input`, where 3 was taken for the input, the option is what is wrong.
  std::string unknown_argument() const
  {
    const std::vector<std::string> all = m_app.remaining(true);
    for (const std::string& argument : all)
      if (argument.size() > 1 && argument[0] == '-') return argument;
    return all.empty() ? "" : all.front();
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
    if (line.command == "harmonic") line.options = m_harmonic;
    if (line.command == "compare") line.options = m_compare;
    m_flow.balance = static_cast<Balance_choice>(place_of(m_balance, balances));
    if (line.command == "flow") line.options = m_flow;
    if (line.command != "spin") return line;
    if (!m_on.empty()) m_spin.rho.on_faces = m_on == "faces";
    m_spin.rho.projection = static_cast<Projection>(place_of(m_projection, projections));
    m_spin.generalized = m_problem == "generalized";
    m_spin.solver = m_solver;
#ifndef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
    if (m_solver == "cholmod")
      throw Failure(Exit_code::usage,
                    "this program was built without CHOLMOD; try: --solver native");
#endif
    line.options = m_spin;
    return line;
  }

  Common_options m_common;
  Info_options m_info;
  Spin_options m_spin;
  Flow_options m_flow;
  Harmonic_options m_harmonic;
  Compare_options m_compare;
  std::string m_on, m_problem = "standard", m_solver = "native", m_projection = "uv",
                    m_balance = "none";
  CLI::App m_app;
};

}  // namespace

Command_line parse_command_line(int argc, const char* const* argv)
{
  return Parser().parse(argc, argv);
}

}  // namespace conformal
