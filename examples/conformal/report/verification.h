// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <optional>
#include <string>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// \brief What a result is judged by: a command gives all that it has. The numbers are those of the
/// surface as it is written.
struct Evidence {
  const CGP::Points& positions;
  std::optional<CGP::Spin_report> spin = {};  ///< of solutions of the Dirac equation
  std::optional<CGP::Conformality> map = {};  ///< of other maps
  std::string fault = {};                     ///< found by the method itself, empty if none
};

/// \brief Whether a result can be trusted, and the numbers that are told of it.
///
/// Only `judge()` decides on results of the program, and only `Session::conclude()` acts upon it.
struct Verdict {
  std::string fault;       ///< why it cannot be trusted, with what to try; empty if it can
  bool is_forced = false;  ///< the user wants the result in any case
  std::optional<CGP::Conformality> map = {};
  std::optional<double> closure_residual = {};

  bool is_verified() const { return fault.empty(); }
};

/// \brief Judges a result.
/// \param easier what to try that asks for less
Verdict judge(const Evidence& evidence, const CGP::Spin_report::Limits& limits,
              const std::string& easier);

/// Why the solution of a Dirac equation cannot be trusted, with what to try; empty if it can.
///
/// The limits let moderate edits of scans pass (whose mean Q is below 1.05, and whose few flips are
/// at slivers) and stop maps that are torn or crumpled.
std::string objection(const CGP::Spin_report& report, const CGP::Points& positions,
                      const CGP::Spin_report::Limits& limits, const std::string& easier);

/// Likewise, for properties of the map only.
std::string objection(const CGP::Conformality& map, const CGP::Spin_report::Limits& limits,
                      const std::string& easier);

/// What a solution has realised of rho, with what to try, if that is too little; empty otherwise.
std::string shortfall(const CGP::Spin_report& report);

/// the number of faces that were measured: without thin faces, where these were taken as they are
int measured_faces(const CGP::Spin_report& report, int faces);

/// these faces of a mesh
CGP::Mesh_view measured_part(const CGP::Mesh_view& mesh, bool is_mollified);

}  // namespace conformal
