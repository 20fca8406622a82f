// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <array>
#include <atomic>
#include <cstring>
#include <string_view>

namespace conformal {

/// \brief A text that is kept ready for a signal handler, which may not allocate.
///
/// It is in one of two buffers, of which the other is filled anew; the end of a long text is left
/// out. One thread sets it.
class Signal_text {
 public:
  void set(std::string_view text)
  {
    auto& buffer = m_current == m_buffers[0].data() ? m_buffers[1] : m_buffers[0];
    buffer[text.copy(buffer.data(), buffer.size() - 1)] = '\0';
    m_current = buffer.data();
  }

  const char* get() const noexcept { return m_current; }

 private:
  std::array<std::array<char, 4096>, 2> m_buffers{};
  std::atomic<const char*> m_current{""};
};

/// Safe to call in a signal handler.
inline void write_to_stderr(const char* text) noexcept
{
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text, std::strlen(text));
}

}  // namespace conformal
