// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_REPORT_FILES_H
#define CONFORMAL_REPORT_FILES_H

#include "Session.h"
#include "io/Temporary_file.h"

#include <optional>
#include <string>

namespace conformal {

/// \brief The files that tell about a run: JSON, which tells about failures too, and HTML. They are
/// opened before the work, so that a folder that cannot be written to is known by then.
class Report_files {
 public:
  /// \throws Failure if HTML reports were not built in; Write_error
  void open(const Common_options& options);

  /// HTML only if there is something to show.
  /// \param error how the run ended, empty if well. \throws Write_error
  void write(Session& session, const std::string& error);

 private:
  std::optional<Temporary_file> m_json, m_html;
};

}  // namespace conformal

#endif
