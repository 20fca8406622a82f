// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "status_line.h"

#include "Signal_text.h"

#include <ctime>

namespace conformal {
namespace {

Signal_text status;
const std::time_t begin = std::time(nullptr);

void write_number(std::time_t number) noexcept
{
  if (number >= 10) write_number(number / 10);
  const char digit[] = {static_cast<char>('0' + number % 10), '\0'};
  write_to_stderr(digit);
}

}  // namespace

void set_status(const std::string& text)
{
  status.set(text);
}

void write_status() noexcept
{
  if (status.get()[0] == '\0') return;
  write_to_stderr("conformal: progress: ");
  write_to_stderr(status.get());
  write_to_stderr(", after ");
  write_number(std::time(nullptr) - begin);
  write_to_stderr(" s\n");
}

}  // namespace conformal
