// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "encode_text.h"

#include <algorithm>

namespace conformal {

void append_value(std::string& text, const Property& property, std::size_t i)
{
  if (is_integer(property.type()))
    append_number(text, property.integer(i));
  else if (property.type() == Value_type::float32)
    append_number(text, static_cast<float>(property.value(i)));
  else
    append_number(text, property.value(i));
}

void append_word(std::string& text, double value)
{
  text += ' ';
  append_number(text, value);
}

std::string on_one_line(std::string text)
{
  std::replace(text.begin(), text.end(), '\n', ' ');
  std::replace(text.begin(), text.end(), '\r', ' ');
  return text;
}

}  // namespace conformal
