// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <sys/stat.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace conformal {

/// A file that appears under its name only when it is complete.
///
/// Writes to a file without a name in the folder of the target, which the system removes however
/// the program ends; `commit()` flushes it to disk, and names and renames it, so that the target is
/// either the old file or the new one, never a part. Where the system has no such files, it is
/// `.conformal-PID-N.tmp`, and the destructor removes it. A device or pipe is written directly; a
/// symbolic link is preserved, and its target is replaced. The new file has the old one's mode and,
/// if the system allows it, its owner. Every failure is a `Write_error` with the system's reason,
/// except that the reader of standard output may end: what it would have read is dropped.
class Temporary_file {
 public:
  enum class Name { if_necessary, at_once };  ///< when the file gets a name before the target's

  explicit Temporary_file(const std::string& target, Name name = Name::if_necessary);
  ~Temporary_file();
  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;

  void write(std::string_view bytes);

  /// what has been written, as the system has it; nothing of a device or pipe
  std::optional<std::string> read_back() const;

  void commit();

  /// whether the file will have another owner or group than the one that it replaces
  bool changes_owner() const { return m_changes_owner; }

 private:
  void take_after(const struct stat& old);
  void rename();
  void open_nameless();
  template <class Create>
  void create_named(const Create& create, const std::string& fault);
  void close_file();
  void flush_folder() const;
  [[noreturn]] void fail(const std::string& what) const;

  std::string m_target;     // as the user wrote it, for messages
  std::string m_path;       // what will be replaced
  std::string m_temporary;  // empty if there is none, or it has no name
  std::size_t m_slot;       // of the register of temporaries
  int m_file = -1;
  bool m_is_direct = false, m_changes_owner = false;
};

/// told the name of every file that is written, as the user wrote it
using Listener_to_written_files = void (*)(const std::string& path);
void tell_written_files_to(Listener_to_written_files listener) noexcept;

/// Whether a file has got its name and the listener may not know yet. Safe to call in a signal
/// handler.
bool is_renaming_file() noexcept;

/// Removes all temporary files that exist now. Safe to call in a signal handler.
void remove_temporary_files() noexcept;

/// Writes a whole file, or leaves the old one as it is. \throws Write_error
void write_file(const std::string& path, std::string_view bytes);

}  // namespace conformal
