// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Common_options.h"
#include "Pace.h"

#include <string>

namespace conformal {

/// how far the work is
struct Progress_state {
  std::string stage;      ///< one word
  double fraction;        ///< done, in [0, 1]
  std::string text = {};  ///< for people, in place of the stage
  int step = 0;           ///< of the stage, counted from 1; 0: it has no steps
};

/// \brief Shows progress on stderr as `--advanced progress` says.
///
/// On a terminal that is a line that changes, and is erased at the end; elsewhere it is the
/// status line, which a signal handler writes every ten seconds; as JSON, an object on a line of
/// its own where a stage begins, and ten a second at most within it: `command`, `stage`, `step` if
/// it has steps, `fraction`, `text` and `seconds`.
class Progress {
 public:
  /// \param part what texts begin with
  explicit Progress(const Common_options& options, std::string command = "", std::string part = "",
                    Pace& pace = Pace::of_run());
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(const Progress_state& state);

  /// Clears the progress line, before another line is written.
  void clear();

  /// the work is done: there is no line any more
  void end();

 private:
  enum class Form { none, bar, lines, json };

  static Form form_for(const Common_options& options);
  std::string text(const Progress_state& state) const;
  void show_bar(const Progress_state& state);
  void show_json(const Progress_state& state);

  Form m_form;
  std::string m_command, m_part, m_stage;
  Pace& m_pace;
  bool m_has_bar = false;
};

}  // namespace conformal
