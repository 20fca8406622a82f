// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace conformal {

struct Glb_numbers;

/// A number of things, or that of one in a list.
/// \throw nlohmann::json::exception if it is none
std::size_t whole_number(const nlohmann::json& value);

/// likewise, of an object that may not have it
std::size_t whole_number(const nlohmann::json& object, const char* key, std::size_t otherwise);

/// \brief The description (JSON) of a GLB or glTF file, and the tables of numbers in its buffers.
///
/// Reading the description throws `nlohmann::json::exception` where it is not as it should be:
/// `refuse_item()` is for those who catch it.
class Glb_content {
 public:
  using Rows = std::vector<std::array<double, 4>>;

  /// \throws Read_error
  Glb_content(std::string_view bytes, const std::string& path);

  const nlohmann::json& json() const { return m_json; }

  /// the item of a list of the description, as in `item("nodes", 3)` \throws Read_error
  const nlohmann::json& item(const std::string& list, std::size_t index) const;

  /// The rows of an accessor; integers that are said to be normalized are from 0 or -1 to 1.
  /// \throws Read_error
  Rows rows(std::size_t accessor) const;

  /// Tells that the item asked for last is wrong. \throws Read_error
  [[noreturn]] void refuse_item() const;

 private:
  void read_chunks(std::string_view bytes);
  void read_description(std::string_view text);
  void check_extensions() const;
  void decode_buffers();
  std::string_view buffer(std::size_t index) const;
  std::string_view view(std::size_t index) const;
  Glb_numbers numbers_of(const nlohmann::json& table) const;
  Rows rows(const nlohmann::json& place, const Glb_numbers& numbers, std::size_t count) const;
  void replace_rows(Rows& rows, const nlohmann::json& sparse, const Glb_numbers& numbers) const;
  [[noreturn]] void fail(const std::string& message) const;

  std::string m_path;
  std::size_t m_size;      // of the file
  bool m_is_text = false;  // `.gltf`: a description alone
  nlohmann::json m_json;
  std::string_view m_binary;
  std::vector<std::string> m_decoded;  // buffers that are text in the description
  mutable std::string m_item = "the description";
};

}  // namespace conformal
