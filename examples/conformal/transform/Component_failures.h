// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "conformal/process/Failure.h"

#include <Conformal_geometry_processing/mesh/Mesh_component.h>

#include <cstddef>
#include <functional>
#include <string>
#include <utility>

namespace conformal {

/// which components of a surface failed, and why
class Component_failures {
 public:
  /// \param path the file name in messages
  Component_failures(std::string path, std::size_t components)
      : m_path(std::move(path)), m_components(components)
  {}

  /// \brief Works on a component, and records the reason if it fails.
  /// \returns the reason, or nothing on success
  /// \throws exceptions that do not concern this component only: signals, lack of memory
  std::string attempt(const std::string& name, const std::function<void()>& work);

  std::size_t size() const { return m_reasons.size(); }
  bool are_all() const { return size() == m_components; }

  /// how many, each reason and the first components that failed for it
  std::string text() const;

  /// what ends the command
  Failure failure() const;

 private:
  std::string reason_of(const std::function<void()>& work);

  std::string m_path;
  std::size_t m_components;
  bool m_is_of_data = false;
  Conformal_geometry_processing::internal::Failure_reasons m_reasons;
};

}  // namespace conformal
