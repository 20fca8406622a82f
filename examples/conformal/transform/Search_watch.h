// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/process/Progress.h"
#include "conformal/report/Session.h"

#include <Conformal_geometry_processing/spin/Spin_report.h>
#include <Quaternionic_linear_algebra/krylov/Eigensolver_result.h>

#include <string>

namespace conformal {

/// \brief Observes a search, as what its library function asks after each iteration whether to go
/// on: shows its progress, notes once that it takes long, and stops it on a signal.
class Search_watch {
 public:
  /// \param tolerance of the search, for the share of it that is done
  /// \param words said before those of progress
  Search_watch(Session& session, double tolerance, std::string words = "");

  bool operator()(const CGP::Eigensolver_progress& progress);

  /// \brief The search is over: the line of progress goes away. Notes if it has ended before it was
  /// done. \throws Failure if a signal has come
  void end(const CGP::Spin_report& report = {});

 private:
  Session& m_session;
  double m_tolerance;
  std::string m_words;
  Progress m_progress;
  int m_iterations = 0;
};

}  // namespace conformal
