// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace Conformal_geometry_processing {

/// \brief Base class of all exceptions thrown by this library.
class Error : public std::runtime_error {
 public:
  /// \param function the function that fails, \param message what, where, how many, and the
  /// requirement
  Error(const std::string& function, const std::string& message)
      : std::runtime_error(function + ": " + message), m_function(function), m_message(message)
  {}

  /// The function that failed
  const std::string& function() const { return m_function; }

  /// The message without the name of the function
  const std::string& message() const { return m_message; }

 private:
  std::string m_function, m_message;
};

/// \brief The data violate a documented precondition; the message names the offending element.
class Precondition_error : public Error {
 public:
  using Error::Error;
};

/// \brief A factorization failed although the preconditions hold.
class Solver_error : public Error {
 public:
  using Error::Error;
};

/// \relates Solver_error
/// Returns whether the solver ran out of memory, by the description of its `Solver_status`
inline bool is_out_of_memory(const Solver_error& error)
{
  return error.message().find("out of memory") != std::string::npos;
}

}  // namespace Conformal_geometry_processing
