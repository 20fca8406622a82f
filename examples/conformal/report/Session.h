// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Outcome.h"

#include "conformal/process/Progress.h"

#include <Quaternionic_linear_algebra/direct/Stopwatch.h>

#include <string>
#include <vector>

namespace conformal {

/// whether a result that does not verify is refused or written
enum class On_fault {
  refuse,           ///< it is not written
  force,            ///< it is written, with a note, and the run has not failed
  fail_in_the_end,  ///< it is written, and the run has failed
};

/// `--force`
inline On_fault on_fault(bool is_forced)
{
  return is_forced ? On_fault::force : On_fault::refuse;
}

/// One run of a command: its options, its outcome and its clock.
class Session {
 public:
  /// \param part the component on which it works, for lines of progress; its notes are not printed
  explicit Session(const Common_options& options, std::string part = "");

  const Common_options& options() const { return m_options; }
  const std::string& part() const { return m_part; }
  Outcome& outcome() { return m_outcome; }
  Report& report() { return m_outcome.report; }

  /// The file that the command works on, by which errors name it; empty before it is known.
  const std::string& input() const { return m_input; }
  void set_input(const std::string& path) { m_input = path; }

  /// Notes, once, a change of the input that was not requested: a line on stderr, and in the
  /// report.
  void note(const std::string& text);
  void note_all(const std::vector<std::string>& texts);

  /// \brief Records the verdict on the result, from which the exit code follows.
  /// \param what the cause, for the message; by default the input
  /// \throws Failure if the result does not verify and is refused
  void conclude(Verdict verdict, On_fault on_fault, const std::string& what);
  void conclude(Verdict verdict, On_fault on_fault) { conclude(verdict, on_fault, m_input); }

  /// shows that of the command, or of its work on a component
  Progress progress() const { return Progress(m_options, m_outcome.command, m_part); }

  /// Ends a stage that began when the last one ended.
  void end_stage(const std::string& stage) { m_outcome.seconds.add(stage, m_watch.lap()); }

  /// Begins a stage whose seconds the outcome has from elsewhere.
  void begin_stage() { m_watch.lap(); }

  /// Writes the report even if the run was interrupted, because there is a result.
  void keep_report() { m_keeps_report = true; }
  bool keeps_report() const { return m_keeps_report; }

  /// Ends the clock, and records how the run ended (no error: an empty string).
  const Outcome& finished(const std::string& error);

 private:
  const Common_options& m_options;
  std::string m_part, m_input;
  Outcome m_outcome;
  bool m_keeps_report = false;
  Conformal_geometry_processing::internal::Stopwatch m_watch, m_total;
};

}  // namespace conformal
