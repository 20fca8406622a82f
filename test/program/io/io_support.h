// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "conformal/io/data/Surface_file.h"
#include "conformal/io/file/io_errors.h"
#include "support/Temporary_folder.h"

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

using Folder = cgp_test::Temporary_folder;
using cgp_test::content;
using cgp_test::put_file;

}  // namespace io_test
