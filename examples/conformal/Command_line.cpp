// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Command_line.h"

#include "conformal/commands/curve_command_line.h"
#include "conformal/commands/editing_options.h"
#include "conformal/commands/flatten_options.h"
#include "conformal/commands/flow_command_line.h"
#include "conformal/commands/help_texts.h"
#include "conformal/commands/option_groups.h"
#include "conformal/commands/spectrum_command_line.h"
#include "conformal/process/Failure.h"
#include "conformal/process/versions.h"

#include <CLI/CLI.hpp>

#include <vector>

namespace conformal {
namespace {

class Parser {
 public:
  Parser() : m_app(about, "conformal")
  {
    m_app.require_subcommand(1);
    m_app.set_version_flag("--version", versions);
    add_info();
    add_spin();
    add_flow();
    add_boundary_command();
    add_fit();
    add_blend();
    add_flatten();
    add_curve();
    add_harmonic();
    add_spectrum();
    add_sphere();
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
    add_json(*command, m_common.json);
    command->add_option("--threads", m_common.threads, "threads of the linear algebra")
        ->check(above_zero)
        ->capture_default_str();
    command->add_flag("-q,--quiet", m_common.quiet, "print nothing but errors");
    command->add_flag("--strict", m_common.strict, "refuse what would be repaired with a note");
    return command;
  }

  // A command that works on a surface; files that must fit it are repaired alike.
  CLI::App* add_command_that_repairs(const char* name, const char* description)
  {
    return add_repair(add_command(name, description), m_common.repair);
  }

  void add_info()
  {
    CLI::App* command = add_command_that_repairs("info", about_info);
    add_input(*command, m_info.input);
  }

  CLI::Option* add_output(CLI::App& command, const char* what = "where the result goes")
  {
    return command.add_option("-o,--output", m_common.output, what)->check(file_name);
  }

  void add_output_and_page(CLI::App& command)
  {
    add_output(command)->required();
    add_html(command, m_common.html);
  }

  void add_spin()
  {
    CLI::App& command = add_each_component(*add_command_that_repairs("spin", about_spin), m_common);
    add_input(command, m_spin.input);
    add_output_and_page(command);
    add_rho(command, m_spin.rho)->require_option(1);
    add_filter(command, m_spin.rho.filter);
    add_boundary(command, m_spin.boundary);
    add_solver(command, m_spin);
    add_mollification(command, m_spin.mollification, tried_otherwise);
    command
        .add_option("--problem", m_problem,
                    "standard, or generalized for rho on faces where that can be trusted")
        ->check(CLI::IsMember({"standard", "generalized"}))
        ->capture_default_str();
    command.add_flag("--open-handles", m_spin.open_handles,
                     "apply rho in one step, also the part of it that shears handles and holes");
    add_eigenvector(command, m_common);
    add_limits(command, m_spin.limits, m_spin.force);
  }

  void add_boundary_command()
  {
    CLI::App& command = *add_command_that_repairs("boundary", about_boundary);
    Spin_options& spin = m_boundary.spin;
    add_input(command, spin.input);
    add_output_and_page(command);
    add_prescription(command, m_boundary.prescription);
    CLI::Option_group* rho = add_rho(command, spin.rho);
    rho->add_flag("--minimal", m_boundary.minimal,
                  "minus the mean curvature: the result is a minimal surface");
    rho->require_option(0, 1);
    add_solver(command, spin);
    add_eigenvector(command, m_common);
    add_limits(command, spin.limits, spin.force);
  }

  void add_fit()
  {
    CLI::App& command = *add_command_that_repairs("fit", about_fit);
    add_fit_options(command, m_fit);
    add_output_and_page(command);
    add_eigenvector(command, m_common);
    add_limits(command, m_fit.spin.limits, m_fit.spin.force);
  }

  void add_blend()
  {
    CLI::App& command = *add_command_that_repairs("blend", about_blend);
    add_blend_options(command, m_blend);
    add_output_and_page(command);
    add_eigenvector(command, m_common);
    add_limits(command, m_blend.spin.limits, m_blend.spin.force);
  }

  void add_flow()
  {
    CLI::App& command = add_each_component(*add_command_that_repairs("flow", about_flow), m_common);
    add_input(command, m_flow.input);
    add_output_and_page(command);
    add_flow_options(command, m_flow);
    add_eigenvector(command, m_common);
    add_limits(command, m_flow.limits, m_flow.force);
  }

  void add_flatten()
  {
    CLI::App& command =
        add_each_component(*add_command_that_repairs("flatten", about_flatten), m_common);
    add_flatten_options(command, m_flatten);
    add_output_and_page(command);
    add_limits(command, m_flatten.limits, m_flatten.force);
  }

  void add_curve()
  {
    CLI::App& command = *add_command("curve", about_curve);
    add_curve_options(command, m_curve);
    add_output(command)->required();
  }

  void add_harmonic()
  {
    CLI::App* command = add_command_that_repairs("harmonic", about_harmonic);
    add_input(*command, m_harmonic.input);
    add_output(*command, "the mesh with the fields");
    command->add_option("--form", m_harmonic.form, "write only this one, counted from 0")
        ->check(CLI::NonNegativeNumber);
  }

  void add_spectrum()
  {
    CLI::App& command = *add_command_that_repairs("spectrum", about_spectrum);
    add_output(command, "the surface of an eigenfunction");
    add_spectrum_options(command, m_spectrum);
    add_eigenvector(command, m_common);
  }

  void add_sphere()
  {
    CLI::App& command = *add_command("sphere", about_sphere);
    add_sphere_options(command, m_sphere);
    add_output(command)->required();
  }

  void add_compare()
  {
    CLI::App* command = add_command("compare", about_compare);
    command->add_option("before", m_compare.before, "mesh file")->required();
    command->add_option("after", m_compare.after, "mesh file with the same faces")->required();
    add_output(*command, "the second mesh, with quality");
    add_html(*command, m_common.html);
  }

  void require_command(const std::string& name) const
  {
    if (name.empty() || name[0] == '-') return;
    const auto has_name = [&](const CLI::App* command) { return command->get_name() == name; };
    if (!m_app.get_subcommands(has_name).empty()) return;
    std::string all;
    for (const CLI::App* command : m_app.get_subcommands([](const CLI::App*) { return true; }))
      all += command->get_name() + ", ";
    throw Failure(Exit_code::usage, "unknown command '" + name + "'; try: " + all + "or --help");
  }

  // In `--wrong 3 input`, where 3 was parsed as the input, the option is the error.
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
    m_spin.generalized = m_problem == "generalized";
    if (line.command == "info") line.options = m_info;
    if (line.command == "spin") line.options = m_spin;
    if (line.command == "flow") line.options = m_flow;
    if (line.command == "boundary") line.options = m_boundary;
    if (line.command == "fit") line.options = m_fit;
    if (line.command == "blend") line.options = m_blend;
    if (line.command == "flatten") line.options = m_flatten;
    if (line.command == "curve") line.options = m_curve;
    if (line.command == "harmonic") line.options = m_harmonic;
    if (line.command == "spectrum") line.options = m_spectrum;
    if (line.command == "sphere") line.options = m_sphere;
    if (line.command == "compare") line.options = m_compare;
    require_solver(m_spin.solver);
    require_solver(m_boundary.spin.solver);
    require_solver(m_blend.spin.solver);
    return line;
  }

  static void require_solver([[maybe_unused]] const std::string& solver)
  {
#ifndef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
    if (solver == "cholmod")
      throw Failure(Exit_code::usage,
                    "this program was built without CHOLMOD; try: --solver native");
#endif
  }

  Common_options m_common;
  Info_options m_info;
  Spin_options m_spin;
  Flow_options m_flow;
  Boundary_options m_boundary;
  Fit_options m_fit;
  Blend_options m_blend;
  Flatten_options m_flatten;
  Curve_options m_curve;
  Harmonic_options m_harmonic;
  Spectrum_options m_spectrum;
  Sphere_options m_sphere;
  Compare_options m_compare;
  std::string m_problem = "standard";
  CLI::App m_app;
};

}  // namespace

Command_line parse_command_line(int argc, const char* const* argv)
{
  return Parser().parse(argc, argv);
}

}  // namespace conformal
