// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#ifndef CONFORMAL_IO_FILE_TEMPORARY_FILE_H
#define CONFORMAL_IO_FILE_TEMPORARY_FILE_H

#include <cstddef>
#include <string>
#include <string_view>

namespace conformal {

/// A file that appears under its name only when it is complete.
///
/// Writes to `.conformal-PID-N.tmp` in the folder of the target; `commit()` flushes it to disk and
/// renames it, so that the target is either the old file or the new one, never a part. Without
/// `commit()` the destructor removes it. A device or pipe is written directly; a symbolic link is
/// preserved, and its target is replaced. The new file has the old one's mode. Every failure is a
/// `Write_error` with the system's reason.
class Temporary_file {
 public:
  explicit Temporary_file(const std::string& target);
  ~Temporary_file();
  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;

  void write(std::string_view bytes);
  void commit();

 private:
  void open_temporary();
  void close_file();
  void flush_folder() const;
  [[noreturn]] void fail(const std::string& what) const;

  std::string m_target;     // as the user wrote it, for messages
  std::string m_path;       // what will be replaced
  std::string m_temporary;  // empty if the target is written directly
  std::size_t m_slot;       // of the register of temporaries
  int m_file = -1;
};

/// Removes all temporary files that exist now. Safe to call in a signal handler.
void remove_temporary_files() noexcept;

/// Writes a whole file, or leaves the old one as it is. \throws Write_error
void write_file(const std::string& path, std::string_view bytes);

}  // namespace conformal

#endif
