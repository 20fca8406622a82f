// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_REPORT_SESSION_H
#define CONFORMAL_REPORT_SESSION_H

#include "Exhibit.h"
#include "Report.h"

#include "conformal/process/Common_options.h"

#include <Conformal_geometry_processing/linear_algebra/direct/Stopwatch.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace conformal {

/// One run of a command: its options, its report, and its output for the user.
class Session {
 public:
  Session(const Common_options& options, const std::string& command);

  const Common_options& options() const { return m_options; }
  Report& report() { return m_report; }

  /// The file that the command works on, by which errors name it; empty before it is known.
  const std::string& input() const { return m_input; }
  void set_input(const std::string& path) { m_input = path; }

  /// Notes a change of the input that was not requested: a line on stderr, and in the report.
  void note(const std::string& text);
  void note_all(const std::vector<std::string>& texts);
  const std::vector<std::string>& notes() const { return m_notes; }

  /// Prints a result on stdout, unless the user has requested quiet operation.
  void print(std::string_view text) const;

  /// Ends a stage that began when the last one ended.
  void end_stage(const std::string& stage) { m_report.add_seconds(stage, m_watch.lap()); }

  /// Begins a stage whose seconds the report has from elsewhere.
  void begin_stage() { m_watch.lap(); }

  /// Writes the report even if the run was interrupted, because there is a result.
  void keep_report() { m_keeps_report = true; }
  bool keeps_report() const { return m_keeps_report; }

  /// Stores the shapes of the HTML report.
  void keep_exhibit(Exhibit exhibit) { m_exhibit = std::move(exhibit); }
  const std::optional<Exhibit>& exhibit() const { return m_exhibit; }

  /// the report, finished: notes, total time and how the run ended (no error: an empty string)
  std::string json(const std::string& error);

 private:
  const Common_options& m_options;
  Report m_report;
  std::vector<std::string> m_notes;
  std::string m_input;
  bool m_keeps_report = false;
  std::optional<Exhibit> m_exhibit;
  Conformal_geometry_processing::internal::Stopwatch m_watch, m_total;
};

}  // namespace conformal

#endif
