// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "Exhibit.h"
#include "Report.h"
#include "verification.h"

#include "conformal/process/Failure.h"

#include <Conformal_geometry_processing/mesh/topology.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace conformal {

/// the seconds of each stage, in order
class Stage_seconds {
 public:
  void add(const std::string& stage, double seconds);
  void add(const Stage_seconds& other);

  const std::vector<std::pair<std::string, double>>& stages() const { return m_stages; }

 private:
  std::vector<std::pair<std::string, double>> m_stages;
};

/// how a run ended
struct Ending {
  Exit_code code = Exit_code::done;
  std::string error = {};  ///< one line; empty if it ended well
};

struct Component_outcome;

/// All that a run has to tell: JSON, the tables and the HTML page are printed from it.
struct Outcome {
  std::string command;
  Report report;                              ///< options, what was read and measured
  std::optional<Verdict> verdict;             ///< on results that are judged
  std::vector<Component_outcome> components;  ///< with `--each-component`, in order
  std::vector<std::string> notes;             ///< changes that were not requested
  Stage_seconds seconds;
  std::optional<Exhibit> exhibit;  ///< for the HTML page
  std::string error;               ///< of what ended the run before its end

  /// failed, if the result does not verify and that was not forced
  Ending ending() const;
};

/// what came of one component
struct Component_outcome {
  int first_vertex;  ///< in the file
  CGP::internal::Topology topology;
  Outcome outcome;
};

/// the outcome as an indented JSON object, UTF-8, with a line break at its end
std::string to_json(const Outcome& outcome);

}  // namespace conformal
