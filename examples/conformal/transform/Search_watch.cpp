// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Search_watch.h"

#include "conformal/process/interruption.h"
#include "conformal/process/text.h"

#include <cmath>
#include <utility>

namespace conformal {

Search_watch::Search_watch(Session& session, double tolerance, std::string words)
    : m_session(session),
      m_tolerance(tolerance),
      m_words(std::move(words)),
      m_progress(session.progress())
{
  m_progress.show({"factorization", 0, m_words + "factorization"});
}

bool Search_watch::operator()(const CGP::Eigensolver_progress& progress)
{
  const int dear = 250;  // iterations: some ten times those of most results
  if (++m_iterations == dear) {
    m_progress.clear();
    m_session.note("this takes long: " + std::to_string(dear) +
                   " iterations, where most results take 20 to 40; a signal (Ctrl-C) ends it");
  }
  m_progress.show({"iteration", std::log(progress.estimate) / std::log(m_tolerance),
                   m_words + "iteration " + std::to_string(progress.iteration + 1) + ", residual " +
                       text_of(progress.estimate, 2),
                   progress.iteration + 1});
  return signal_received() == 0;
}

void Search_watch::end(const CGP::Spin_report& report)
{
  m_progress.end();
  throw_if_interrupted();
  if (report.is_unfinished)
    m_session.note("the search has ended after " + std::to_string(m_iterations) +
                   " iterations with the best surface that it had");
}

}  // namespace conformal
