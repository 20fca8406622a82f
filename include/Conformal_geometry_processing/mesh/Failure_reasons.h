// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgMesh
/// \brief The reasons why components of a mesh failed: each reason once, with the first components
/// that failed for it and the number of the others.
///
/// A mesh may have 100,000 small components that fail for different reasons: reasons beyond the
/// first few are only counted, so that time is linear, and memory and text are bounded.
class Failure_reasons {
 public:
  /// Maximal number of reported reasons, and of names per reason
  static constexpr std::size_t max_reasons = 5, max_names = 5;

  /// \param name of the component in messages
  void add(const std::string& name, const std::string& reason);

  /// Number of failed components
  std::size_t size() const { return m_size; }

  /// `NAME, NAME and 7 more: REASON; NAME: REASON; 9 more for other reasons`, in the order of their
  /// occurrence
  std::string text() const;

 private:
  struct Group {
    std::string reason, names;
    std::size_t size;  // number of components
  };

  static std::string more(std::size_t count) { return std::to_string(count) + " more"; }

  std::vector<Group> m_groups;
  std::size_t m_size = 0;
};

}  // namespace Conformal_geometry_processing::internal
