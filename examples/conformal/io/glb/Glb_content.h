// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace conformal {

/// \brief The two chunks of a GLB file, and the tables of numbers in the second one.
///
/// The functions throw `nlohmann::json::exception` where the description is not as it should be.
class Glb_content {
 public:
  /// \throws Read_error
  Glb_content(std::string_view bytes, const std::string& path);

  const nlohmann::json& json() const { return m_json; }

  /// The rows of an accessor; integers that are said to be normalized are from 0 or -1 to 1.
  /// \throws Read_error
  std::vector<std::array<double, 4>> rows(std::size_t accessor) const;

 private:
  std::string_view view(std::size_t index) const;

  std::string m_path;
  nlohmann::json m_json;
  std::string_view m_binary;
};

}  // namespace conformal
