// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_GEOMETRY_PROCESSING_MESH_FAILURE_REASONS_H
#define CONFORMAL_GEOMETRY_PROCESSING_MESH_FAILURE_REASONS_H

#include <cstddef>
#include <string>
#include <vector>

namespace Conformal_geometry_processing {

/// \ingroup PkgMesh
/// \brief why components of a mesh failed: each reason once, with the first components that failed
/// for it and the number of the others.
///
/// A mesh may have 100,000 crumbs, each with a reason of its own: reasons beyond the first few are
/// counted only, so that time is linear, and memory and text are bounded.
class Failure_reasons {
 public:
  /// how many reasons are told, and how many names for each
  static constexpr std::size_t max_reasons = 5, max_names = 5;

  /// \param name of the component, as messages tell it
  void add(const std::string& name, const std::string& reason);

  /// how many components failed
  std::size_t size() const { return m_size; }

  /// `NAME, NAME and 7 more: REASON; NAME: REASON; 9 more for other reasons`, in the order in which
  /// they came
  std::string text() const;

 private:
  struct Group {
    std::string reason, names;
    std::size_t size;  // how many components
  };

  static std::string more(std::size_t count) { return std::to_string(count) + " more"; }

  std::vector<Group> m_groups;
  std::size_t m_size = 0;
};

}  // namespace Conformal_geometry_processing

#ifdef CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY
#include <Conformal_geometry_processing/mesh/Failure_reasons_impl.h>
#endif

#endif
