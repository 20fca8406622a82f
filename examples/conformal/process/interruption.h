// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <string>

namespace conformal {

/// \brief From now on SIGINT, SIGTERM, SIGHUP and SIGXCPU are heard: the first one asks the work to
/// end, which it does between two iterations, or by force one second later; a second one ends it at
/// once. Temporary files are removed in any case, and a line on stderr tells what was written. A
/// closed pipe and a file that grows beyond the system's limit no longer end the program, but the
/// write fails. Every ten seconds, and on SIGALRM, the status line is written.
void listen_to_signals();

/// the signal that has come, or zero
int signal_received();

/// \brief While one lives, the first signal waits for the work however long it takes, because there
/// is something to be written. A second one still ends the program at once.
class Patience {
 public:
  Patience();
  ~Patience();
  Patience(const Patience&) = delete;
  Patience& operator=(const Patience&) = delete;
};

/// `nothing was written`, or which files were
const char* what_was_written() noexcept;

/// whether a file has been written
bool has_written() noexcept;

/// \throws Failure if a signal has come
void throw_if_interrupted(const std::string& consequence = what_was_written());

}  // namespace conformal
