// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_REPORT_VERIFICATION_H
#define CONFORMAL_REPORT_VERIFICATION_H

#include "Report.h"
#include "Table.h"
#include "Verification_limits.h"

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/spin/Spin_report.h>

#include <string>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

/// Why the result of a transformation cannot be trusted, with what to try; empty if it can.
///
/// \param easier what to try that asks for less
///
/// The limits let moderate edits of scans pass (whose mean Q is below 1.05, and whose few flips are
/// at slivers) and stop maps that are torn or crumpled.
std::string objection(const CGP::Spin_report& report, const CGP::Points& positions, int faces,
                      const Verification_limits& limits, const std::string& easier);

/// Likewise, for properties of the map only.
std::string objection(const CGP::Conformality& map, int faces, const Verification_limits& limits,
                      const std::string& easier);

/// Enters the certificate into the report (`result/...`, `seconds/...`).
void report_certificate(const CGP::Spin_report& spin, Report& report);

/// The certificate for the eye.
Table certificate_table(const CGP::Spin_report& spin, int faces);

/// the part of a mesh on which maps are measured: without thin faces, where these were taken as
/// they are
CGP::Mesh_view measured_part(const CGP::Mesh_view& mesh, bool is_mollified);

/// Enters and shows how the triangulation of a mollified surface was built; nothing of another.
void report_mollification(const CGP::Spin_report::Mollification& made, Report& report);
void add_mollification(const CGP::Spin_report::Mollification& made, Table& table);

/// Reports and prints the part that concerns the map only.
void report_conformality(const CGP::Conformality& map, Report& report);
void add_conformality(const CGP::Conformality& map, int faces, Table& table);

}  // namespace conformal

#endif
