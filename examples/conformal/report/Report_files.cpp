// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Report_files.h"

#include "html_report.h"
#include "page_blocks.h"

#include "conformal/process/Failure.h"

namespace conformal {
namespace {

void require_html(const std::string& path)
{
  const std::string why = why_no_html_reports();
  if (!why.empty())
    throw Failure(Exit_code::usage, "--html: this program was built without HTML reports: " + why);
  require_page_name(path);
}

}  // namespace

void Report_files::open(const Common_options& options)
{
  if (!options.html.empty()) require_html(options.html);
  if (!options.json.empty()) m_json.emplace(options.json);
  if (!options.html.empty()) m_html.emplace(options.html);
}

void Report_files::write(const Outcome& outcome)
{
  if (!m_json && !m_html) return;
  const std::string json = to_json(outcome);
  if (m_json) {
    m_json->write(json);
    m_json->commit();
  }
  if (!m_html || !outcome.error.empty() || !outcome.exhibit) return;
  m_html->write(html_report(*outcome.exhibit, json));
  m_html->commit();
}

}  // namespace conformal
