// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

namespace cgp_test {

/// a folder that goes away with the object
class Temporary_folder {
 public:
  Temporary_folder()
  {
    std::random_device random;
    const std::filesystem::path parent = std::filesystem::temp_directory_path();
    do m_path = parent / ("conformal-test-" + std::to_string(random()));
    while (!std::filesystem::create_directory(m_path));
  }
  ~Temporary_folder() { std::filesystem::remove_all(m_path); }
  Temporary_folder(const Temporary_folder&) = delete;
  Temporary_folder& operator=(const Temporary_folder&) = delete;

  const std::filesystem::path& path() const { return m_path; }
  std::string operator/(const std::string& name) const { return (m_path / name).string(); }
  bool has(const std::string& name) const { return std::filesystem::exists(m_path / name); }

  /// Number of files in it
  std::size_t size() const
  {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(m_path), {}));
  }

 private:
  std::filesystem::path m_path;
};

std::string content(const std::filesystem::path& path);

void put_file(const std::filesystem::path& path, const std::string& bytes);

}  // namespace cgp_test
