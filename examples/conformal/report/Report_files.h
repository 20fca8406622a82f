// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Outcome.h"

#include "conformal/io/file/Temporary_file.h"
#include "conformal/process/Common_options.h"

#include <optional>
#include <string>

namespace conformal {

/// \brief The report files of a run: JSON, which also reports failures, and HTML. They are opened
/// before the work, to detect folders without write permission early.
class Report_files {
 public:
  /// \throws Failure if HTML reports were not built in; Write_error
  void open(const Common_options& options);

  /// HTML only if there is something to show.
  /// \throws Write_error
  void write(const Outcome& outcome);

 private:
  std::optional<Temporary_file> m_json, m_html;
};

}  // namespace conformal
