// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "Session.h"

#include <Conformal_geometry_processing/version.h>

#include <cstdio>

namespace conformal {

Session::Session(const Common_options& options, const std::string& command) : m_options(options)
{
  m_report.set("command", command);
  m_report.set("version", CONFORMAL_GEOMETRY_PROCESSING_VERSION);
}

void Session::note(const std::string& text)
{
  m_notes.push_back(text);
  if (!m_options.quiet) std::fprintf(stderr, "conformal: note: %s\n", text.c_str());
}

void Session::note_all(const std::vector<std::string>& texts)
{
  for (const std::string& text : texts) note(text);
}

void Session::print(std::string_view text) const
{
  if (!m_options.quiet) std::fwrite(text.data(), 1, text.size(), stdout);
}

std::string Session::json(const std::string& error)
{
  m_report.add_seconds("total", m_total.lap());
  m_report.set("notes", m_notes);
  if (!error.empty()) {
    m_report.set("verified", false);
    m_report.set("error", error);
  }
  return to_json(m_report);
}

}  // namespace conformal
