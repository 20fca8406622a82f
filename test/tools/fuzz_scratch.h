// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "fuzz_trials.h"
#include "support/Temporary_folder.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#if defined(__SANITIZE_ADDRESS__)
#define CGP_HAS_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define CGP_HAS_ADDRESS_SANITIZER
#endif
#endif
#ifdef CGP_HAS_ADDRESS_SANITIZER
#include <sanitizer/common_interface_defs.h>
#endif

// Input, output and messages of a run.

namespace fuzz {

class Scratch {
 public:
  Scratch() : m_terminal{::dup(STDOUT_FILENO), ::dup(STDERR_FILENO)}
  {
    m_messages = ::memfd_create("messages", 0);
#ifdef CGP_HAS_ADDRESS_SANITIZER
    // The sanitizers speak to the terminal also while the program speaks to us.
    __sanitizer_set_report_fd(reinterpret_cast<void*>(static_cast<std::intptr_t>(m_terminal[1])));
#endif
  }

  std::string path(const std::string& name) const
  {
    return m_folder / name;
  }
  bool has(const std::string& name) const
  {
    return m_folder.has(name);
  }

  bool has_only(const std::vector<std::string>& names) const
  {
    const std::filesystem::directory_iterator files(m_folder.path()), end;
    return std::all_of(files, end, [&](const auto& entry) {
      return std::find(names.begin(), names.end(), entry.path().filename()) != names.end();
    });
  }

  void clear() const
  {
    for (const auto& entry : std::filesystem::directory_iterator(m_folder.path()))
      std::filesystem::remove_all(entry.path());
  }

  void write(const std::string& name, const std::string& content) const
  {
    cgp_test::put_file(path(name), content);
  }

  std::string content(const std::string& name) const
  {
    return cgp_test::content(path(name));
  }

  /// Records terminal output from now on; discards that of earlier runs.
  void begin_listening() const
  {
    require(::ftruncate(m_messages, 0) == 0 && ::lseek(m_messages, 0, SEEK_SET) == 0, "no memory");
    redirect(m_messages, m_messages);
  }

  void end_listening() const
  {
    std::fflush(nullptr);
    redirect(m_terminal[0], m_terminal[1]);
  }

  /// The recorded output
  std::string messages() const
  {
    std::string text(static_cast<std::size_t>(::lseek(m_messages, 0, SEEK_END)), ' ');
    require(::pread(m_messages, text.data(), text.size(), 0) >= 0, "what was said is lost");
    return text;
  }

 private:
  static void redirect(int out, int err)
  {
    std::fflush(nullptr);
    ::dup2(out, STDOUT_FILENO);
    ::dup2(err, STDERR_FILENO);
  }

  int m_terminal[2];
  int m_messages = -1;
  cgp_test::Temporary_folder m_folder;
};

}  // namespace fuzz
