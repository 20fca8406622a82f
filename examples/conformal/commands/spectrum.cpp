// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "spectrum.h"

#include "conformal/input/Surface_input.h"
#include "conformal/io/file/Temporary_file.h"
#include "conformal/io/file/numbers.h"
#include "conformal/io/write_surface.h"
#include "conformal/process/Failure.h"
#include "conformal/process/interruption.h"
#include "conformal/report/Table.h"
#include "conformal/transform/suitable_surface.h"
#include "conformal/transform/write_result.h"

#include <Conformal_geometry_processing/mesh/boundary_loops.h>
#include <Conformal_geometry_processing/spin/Dirac_spectral_problem.h>
#include <Conformal_geometry_processing/surfaces/dirac_sphere.h>

#include <optional>
#include <string>
#include <vector>

namespace conformal {
namespace {

CGP::internal::Dirac_spectrum find(const Surface_input& input, const Spectrum_options& options,
                                   const Common_options& common)
{
  const CGP::Mesh_view& mesh = input.mesh;
  if (options.count > mesh.size_of_vertices())
    throw Failure(Exit_code::usage, "--count " + std::to_string(options.count) + ": " +
                                        options.input + " has only " +
                                        std::to_string(mesh.size_of_vertices()) + " vertices");
  CGP::internal::Dirac_spectrum_options o;
  o.shift = options.shift;
  o.tolerance = common.tolerance;
  o.random_seed = common.seed;
  const auto condition = CGP::boundary_loops(mesh).empty() ? CGP::Boundary_condition::free()
                                                           : CGP::Boundary_condition::binormals();
  CGP::internal::Dirac_spectrum s =
      CGP::internal::Dirac_spectral_problem<>(mesh, condition, "spectrum")
          .find(CGP::no_potential(mesh), options.count, o,
                [](const CGP::internal::Krylov_progress&) { return signal_received() == 0; });
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

void tell(const CGP::internal::Dirac_spectrum& s, const Spectrum_options& options, Session& session)
{
  session.report().set("result/eigenvalues", numbers(s.eigenvalues));
  session.report().set("result/pencil_eigenvalues", numbers(s.pencil_eigenvalues));
  session.report().set("result/residual", s.residuals.maxCoeff());
  session.report().set("result/restarts", s.restarts);
  const double resolution = options.resolution * s.eigenvalues.cwiseAbs().maxCoeff();
  Table table;
  table.add("eigenvalue", std::string("multiplicity"));
  for (const auto& [value, multiplicity] : CGP::with_multiplicities(s.eigenvalues, resolution))
    table.add(text_of(value), multiplicity);
  session.print(table.text());
}

std::string csv_of(const CGP::internal::Dirac_spectrum& s)
{
  std::string text = "number,eigenvalue,pencil_eigenvalue,residual\n";
  for (Eigen::Index k = 0; k < s.size(); ++k) {
    text += std::to_string(k);
    for (const double x : {s.eigenvalues[k], s.pencil_eigenvalues[k], s.residuals[k]}) {
      text += ',';
      append_number(text, x);
    }
    text += '\n';
  }
  return text;
}

void write_surface_of(const Surface_input& input, const CGP::internal::Dirac_spectrum& s,
                      int number, Session& session)
{
  const CGP::Spin_result result =
      CGP::surface_of_spin(input.mesh, s.vectors.col(number), "spectrum");
  session.report().set("result/surface/eigenvalue", s.eigenvalues[number]);
  session.report().set("result/surface/closure_residual", result.report.closure_residual);
  Surface_file file = moved(input, result.positions);
  set_quality(input, result.positions, file);
  session.note_all(write_surface(session.options().output, file));
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
  if (has_output) require_writable(session.options().output);
}

}  // namespace

void spectrum(const Spectrum_options& options, Session& session)
{
  require_consistent(options, session);
  std::optional<Temporary_file> csv;
  if (!options.csv.empty()) csv.emplace(options.csv);
  const Surface_input input = read_suitable_surface(options.input, session);
  const auto s = find(input, options, session.options());
  session.end_stage("solve");
  if (options.surface) write_surface_of(input, s, *options.surface, session);
  if (csv) {
    csv->write(csv_of(s));
    csv->commit();
  }
  session.end_stage("write");
  tell(s, options, session);
}

}  // namespace conformal
