// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_PROCESS_PROGRESS_H
#define CONFORMAL_PROCESS_PROGRESS_H

#include <string>

namespace conformal {

/// A progress line on stderr, only if stderr is a terminal. It is erased at the end.
class Progress {
 public:
  explicit Progress(bool is_quiet);
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// \param fraction done, in [0, 1]
  void show(const std::string& stage, double fraction);
  void clear();

 private:
  bool m_is_shown;
  bool m_has_line = false;
};

}  // namespace conformal

#endif
