// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Command.h"
#include "keyed_options.h"
#include "option_groups.h"

#include "conformal/io/file/Temporary_file.h"
#include "conformal/io/file/numbers.h"
#include "conformal/process/Failure.h"
#include "conformal/process/Progress.h"
#include "conformal/process/interruption.h"
#include "conformal/process/text.h"
#include "conformal/transform/each_component.h"
#include "conformal/transform/suitable_surface.h"
#include "conformal/transform/write_result.h"

#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/spin/Dirac_spectrum.h>
#include <Conformal_geometry_processing/surfaces/spheres.h>

#include <optional>
#include <string>
#include <vector>

namespace conformal {
namespace {

const char* const spectrum_about =
    "Finds eigenvalues of the quaternionic Dirac operator of a surface: those of the smallest\n"
    "modulus, or those nearest to a shift, with sign and multiplicity, in 1/length. Constants "
    "have\n"
    "the eigenvalue 0. At a boundary binormals are kept.\n"
    "--csv writes one line for each; --surface N -o FILE the surface whose spin is eigenfunction "
    "N.\n"
    "Example: conformal spectrum sphere.off --count 16 --csv eigenvalues.csv";

/// what `conformal spectrum` takes
struct Spectrum_options {
  std::string input, csv;
  int count = 10;
  CGP::internal::Dirac_spectrum_options request;
  double resolution = 0.005;  ///< eigenvalues nearer than this share of the largest are told as one
  std::optional<int> surface;  ///< the eigenfunction whose surface is written
  bool force = false;
  CGP::Spin_report::Limits limits;
};

void add_options(CLI::App& command, Spectrum_options& options, Common_options& common)
{
  add_repair(command, common);
  add_components(command, common);
  add_mesh_output(command, common, "the surface of an eigenfunction");
  add_map_limits(command, options.limits, options.force);
  add_input(command, options.input);
  command.add_option("--count", options.count, "how many eigenvalues")
      ->check(above_zero)
      ->capture_default_str();
  command.add_option("--shift", options.request.shift, "those nearest to it, in 1/length")
      ->capture_default_str();
  command.add_option("--csv", options.csv, "write the eigenvalues to this file")->check(file_name);
  advanced(command)
      .add_option("--resolution", options.resolution,
                  "eigenvalues nearer than this share of the largest are shown as one")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command
      .add_option("--surface", options.surface,
                  "write the surface of this eigenfunction, counted from 0")
      ->check(CLI::NonNegativeNumber)
      ->needs("--output");
  add_eigenvector(command, options.request);
}

Files files(const Spectrum_options& spectrum)
{
  return {{"the input", spectrum.input, Named_file::Role::replaceable},
          {"--csv", spectrum.csv, Named_file::Role::written}};
}

CGP::internal::Dirac_spectrum find(const Surface_input& input, const Spectrum_options& options,
                                   Session& session)
{
  const CGP::Mesh_view& mesh = input.mesh;
  if (options.count > mesh.size_of_vertices())
    throw Failure(Exit_code::usage, "--count " + std::to_string(options.count) + ": " +
                                        options.input + " has only " +
                                        std::to_string(mesh.size_of_vertices()) + " vertices");
  const int dear = 80;  // some 200 scalar Poisson problems
  if (options.count >= dear)
    session.note("this takes long: " + std::to_string(options.count) +
                 " eigenvalues, the square of which is the cost; a signal (Ctrl-C) ends it");
  Progress progress = session.progress();
  const auto go_further = [&](const CGP::internal::Krylov_progress& p) {
    progress.show(
        {"round", static_cast<double>(p.vectors) / p.capacity,
         std::to_string(p.converged) + " converged, round " + std::to_string(p.restart + 1),
         p.restart + 1});
    return signal_received() == 0;
  };
  const auto condition = CGP::boundary_loops(mesh).empty() ? CGP::Boundary_condition::free()
                                                           : CGP::Boundary_condition::binormals();
  CGP::internal::Dirac_spectrum s =
      CGP::internal::Dirac_spectral_problem(mesh, condition, "spectrum")
          .find(CGP::no_potential(mesh), options.count, options.request, go_further);
  throw_if_interrupted();
  if (!s.converged)
    throw Failure(Exit_code::failed, options.input +
                                         ": not all eigenvalues were found; try: a "
                                         "smaller --count, or another --shift");
  return s;
}

std::vector<double> numbers(const Eigen::VectorXd& v)
{
  return {v.begin(), v.end()};
}

void tell(const CGP::internal::Dirac_spectrum& s, const Spectrum_options& options, Report& report)
{
  report.set("result/eigenvalues", numbers(s.eigenvalues));
  report.set("result/pencil_eigenvalues", numbers(s.pencil_eigenvalues));
  report.set("result/residual", s.residuals.maxCoeff());
  report.set("result/restarts", s.restarts);
  report.set("result/complete_from", s.shift - s.complete_radius);
  report.set("result/complete_to", s.shift + s.complete_radius);
  report.set("result/is_complete", s.is_complete());
  const double resolution = options.resolution * s.eigenvalues.cwiseAbs().maxCoeff();
  report.show("eigenvalue", "multiplicity");
  for (const auto& [value, multiplicity] : CGP::with_multiplicities(s.eigenvalues, resolution))
    report.show(text_of(value), std::to_string(multiplicity));
  report.show("complete from", text_of(s.shift - s.complete_radius));
  report.show("complete to", text_of(s.shift + s.complete_radius));
}

const char* const csv_head = "number,eigenvalue,pencil_eigenvalue,residual\n";

/// one line for each
/// \param before what they begin with
std::string csv_rows(const CGP::internal::Dirac_spectrum& s, const std::string& before)
{
  std::string text;
  for (Eigen::Index k = 0; k < s.size(); ++k) {
    text += before + std::to_string(k);
    for (const double x : {s.eigenvalues[k], s.pencil_eigenvalues[k], s.residuals[k]}) {
      text += ',';
      append_number(text, x);
    }
    text += '\n';
  }
  return text;
}

/// \brief why these are not the eigenvalues that were asked for; empty if they are
std::string shortage(const CGP::internal::Dirac_spectrum& s)
{
  if (s.is_complete()) return {};
  const auto sure = ((s.eigenvalues.array() - s.shift).abs() <= s.complete_radius).count();
  return "the mesh resolves " + std::to_string(sure) + " of the " + std::to_string(s.wanted) +
         " eigenvalues that were asked for, from " + text_of(s.shift - s.complete_radius) + " to " +
         text_of(s.shift + s.complete_radius) + ", and of " + std::to_string(s.size() - sure) +
         " others shown some between may be missing; try: a smaller --count, or a finer mesh";
}

/// Fewer than asked for are told and written, and the run has failed.
void conclude(const CGP::internal::Dirac_spectrum& s, const Spectrum_options& options,
              Session& session)
{
  Verdict verdict;
  verdict.fault = shortage(s);
  session.conclude(verdict, options.force ? On_fault::force : On_fault::fail_in_the_end);
}

void require_found(int number, const CGP::internal::Dirac_spectrum& s)
{
  if (number >= s.size())
    throw Failure(Exit_code::failed, "eigenfunction " + std::to_string(number) +
                                         " was not found; try: --surface 0 to " +
                                         std::to_string(s.size() - 1));
}

void write_surface_of(const Surface_input& input, const CGP::internal::Dirac_spectrum& s,
                      const Spectrum_options& options, Session& session)
{
  const int number = *options.surface;
  require_found(number, s);
  const CGP::Spin_result result =
      CGP::surface_of_spin(input.mesh, s.vectors.col(number), "spectrum");
  session.report().set("result/surface/eigenvalue", s.eigenvalues[number]);
  session.report().set("result/surface/closure_residual", result.report.closure_residual);
  const Evidence evidence{result.positions, {}, result.report.conformality};
  session.conclude(judge(evidence, options.limits, "another one"), on_fault(options.force));
  write_result(input, {result.positions}, session);
}

void require_consistent(const Spectrum_options& options, const Session& session)
{
  const bool has_output = !session.options().output.empty();
  if (has_output && !options.surface)
    throw Failure(Exit_code::usage, "-o needs --surface, the number of an eigenfunction");
  if (options.surface && *options.surface >= options.count)
    throw Failure(Exit_code::usage,
                  "there is no eigenfunction " + std::to_string(*options.surface) +
                      "; try: --surface 0 to " + std::to_string(options.count - 1));
  if (options.surface && session.options().each_component)
    throw Failure(Exit_code::usage, "--surface is of one component; try: without --each-component");
  if (has_output) require_writable(session.options().output);
}

void spectrum(const Spectrum_options& options, Session& session)
{
  require_consistent(options, session);
  std::optional<Temporary_file> csv;
  if (!options.csv.empty()) csv.emplace(options.csv);
  const Surface_input input = read_suitable_surface(options.input, session);
  const bool has_parts = session.options().each_component;
  std::string table = (has_parts ? "component," : "") + std::string(csv_head);
  int number = 0;
  CGP::internal::Dirac_spectrum last;
  each_component(input, session, [&](const Component& component, Session& own) {
    const std::string before = has_parts ? std::to_string(number++) + ',' : "";
    const auto s = find(component.input, options, own);
    own.end_stage("solve");
    table += csv_rows(s, before);
    tell(s, options, own.report());
    conclude(s, options, own);
    if (!options.surface) return;
    last = s;
    last.vectors(component.vertices, Eigen::indexing::all) = s.vectors;
  });
  if (csv) {
    csv->write(table);
    csv->commit();
  }
  session.end_stage("write");
  if (options.surface) write_surface_of(input, last, options, session);
}

}  // namespace

Command spectrum_command()
{
  return make_command<Spectrum_options>("spectrum", spectrum_about, add_options, files, spectrum);
}

}  // namespace conformal
