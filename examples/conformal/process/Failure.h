// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace conformal {

/// Exit codes of the program
enum class Exit_code : int {
  done = 0,
  failed = 1,      ///< the computation failed, or its result did not verify
  usage = 2,       ///< the command line makes no sense
  unreadable = 3,  ///< an input cannot be read or understood
  unsuitable = 4,  ///< an input was understood but cannot be worked on
  unwritable = 5,  ///< an output cannot be written
  out_of_memory = 6,
  interrupted = 130,  ///< SIGINT
  terminated = 143    ///< SIGTERM
};

/// The failure of a command. The message is one line: what, where, how many; advice.
class Failure : public std::runtime_error {
 public:
  Failure(Exit_code code, const std::string& message) : std::runtime_error(message), m_code(code) {}

  Exit_code code() const noexcept { return m_code; }

 private:
  Exit_code m_code;
};

/// an input file that was understood but cannot be worked on
inline Failure unsuitable(const std::string& path, const std::string& message)
{
  return {Exit_code::unsuitable, path + ": " + message};
}

}  // namespace conformal
