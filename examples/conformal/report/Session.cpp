// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Session.h"

#include "conformal/process/text.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace conformal {

Session::Session(const Common_options& options, std::string part)
    : m_options(options), m_part(std::move(part))
{
  Pace::of_run();  // begins with the first session
}

void Session::note(const std::string& text)
{
  std::vector<std::string>& notes = m_outcome.notes;
  if (std::find(notes.begin(), notes.end(), text) != notes.end()) return;
  notes.push_back(text);
  if (!m_options.quiet && m_part.empty())
    std::fprintf(stderr, "conformal: note: %s\n", printable_line(text).c_str());
}

void Session::note_all(const std::vector<std::string>& texts)
{
  for (const std::string& text : texts) note(text);
}

void Session::conclude(Verdict verdict, On_fault on_fault, const std::string& what)
{
  const bool is_verified = verdict.is_verified();
  const std::string fault = verdict.fault;
  if (!is_verified && !what.empty()) verdict.fault = what + ": " + fault;
  verdict.is_forced = on_fault == On_fault::force;
  // One result that does not verify, of several, decides on all.
  if (!m_outcome.verdict || m_outcome.verdict->is_verified()) m_outcome.verdict = verdict;
  if (is_verified || on_fault == On_fault::fail_in_the_end) return;
  if (on_fault == On_fault::refuse) throw Failure(Exit_code::failed, verdict.fault);
  note("written all the same, as --force says: " + fault);
}

const Outcome& Session::finished(const std::string& error)
{
  m_outcome.seconds.add("total", m_total.lap());
  m_outcome.error = error;
  return m_outcome;
}

}  // namespace conformal
