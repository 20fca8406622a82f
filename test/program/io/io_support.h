// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef TEST_PROGRAM_IO_IO_SUPPORT_H
#define TEST_PROGRAM_IO_IO_SUPPORT_H

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "conformal/io/Surface_file.h"
#include "conformal/io/io_errors.h"

namespace io_test {

/// the message of the error that a call throws, or "no error"
template <class Error = conformal::Read_error, class Function>
std::string message_of(const Function& call)
{
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

/// the corners of face f
inline std::vector<int> corners(const conformal::Surface_file& file, std::size_t f)
{
  const auto begin = file.polygons.corners.begin();
  return {begin + static_cast<std::ptrdiff_t>(file.polygons.first[f]),
          begin + static_cast<std::ptrdiff_t>(file.polygons.first[f + 1])};
}

/// all values of a property, which must be there
inline std::vector<double> values(const conformal::Element& element, std::string_view name)
{
  const conformal::Property* property = conformal::find_property(element, name);
  EXPECT_NE(property, nullptr) << name;
  std::vector<double> result;
  for (std::size_t i = 0; property != nullptr && i < property->values(); ++i)
    result.push_back(property->value(i));
  return result;
}

/// names and types of the properties, as `nx:float red:uchar`
inline std::string types(const conformal::Element& element)
{
  std::string text;
  for (const conformal::Property& property : element.properties)
    text += (text.empty() ? "" : " ") + property.name() + ':' +
            std::string(name_of(property.type())) + (property.is_list() ? "[]" : "");
  return text;
}

/// a folder that is there for one test
class Folder {
 public:
  Folder()
  {
    std::string name = (std::filesystem::temp_directory_path() / "conformal_io_XXXXXX").string();
    EXPECT_NE(::mkdtemp(name.data()), nullptr);
    m_path = name;
  }
  ~Folder() { std::filesystem::remove_all(m_path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string operator/(const std::string& name) const { return (m_path / name).string(); }
  const std::filesystem::path& path() const { return m_path; }

  /// how many files are in it
  std::size_t size() const
  {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(m_path),
                                                  std::filesystem::directory_iterator()));
  }

 private:
  std::filesystem::path m_path;
};

inline std::string content(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline void put_file(const std::string& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace io_test

#endif
