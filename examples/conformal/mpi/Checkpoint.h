// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Distributed_spin.h"

#include <chrono>
#include <string>

namespace conformal::mpi {

/// \brief The file from which a run that was ended is resumed, beside its output: what was asked,
/// where the way was, and the spins in the order of the input, so that any number of processes can
/// go on. All functions are collective.
class Checkpoint {
 public:
  /// \param path of the file \param job what is asked, one line of text
  /// \param seconds between two of them
  Checkpoint(std::string path, std::string job, double seconds);

  /// \brief the state in the file.
  /// \throws Failure if there is none, or it is that of another job
  Search_state read(const Distributed_mesh& mesh) const;

  /// writes the state, unless the last one is too young
  void save(const Distributed_mesh& mesh, const Search_state& state);

  /// after the output has been written
  void remove() const;

 private:
  using Clock = std::chrono::steady_clock;

  std::string m_path, m_job;
  double m_seconds;
  Clock::time_point m_last = Clock::now();
};

}  // namespace conformal::mpi
