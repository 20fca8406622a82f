// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "read_bytes.h"

#include "io_errors.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace conformal {
namespace {

class Input {
 public:
  explicit Input(const std::string& path)
      : m_path(path), m_file(::open(path.c_str(), O_RDONLY | O_CLOEXEC))
  {
    if (m_file < 0) fail("cannot be opened");
  }
  ~Input() { ::close(m_file); }
  Input(const Input&) = delete;
  Input& operator=(const Input&) = delete;

  struct stat status() const
  {
    struct stat status {};
    if (::fstat(m_file, &status) != 0) fail("cannot be examined");
    return status;
  }

  // fills [begin, begin + size) as far as the file goes
  std::size_t read(char* begin, std::size_t size) const
  {
    std::size_t done = 0;
    while (done < size) {
      const ssize_t n = ::read(m_file, begin + done, std::min(size - done, std::size_t{1} << 30));
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) fail("cannot be read");
      if (n == 0) break;
      done += static_cast<std::size_t>(n);
    }
    return done;
  }

  [[noreturn]] void fail(const std::string& what) const
  {
    throw Read_error(m_path, 0, what + ": " + std::strerror(errno));
  }

 private:
  const std::string& m_path;
  int m_file;
};

}  // namespace

std::string read_bytes(const std::string& path, const std::string& wanted)
{
  const Input input(path);
  const struct stat status = input.status();
  if (S_ISDIR(status.st_mode)) throw Read_error(path, 0, "is a directory, wanted " + wanted);
  // One byte more than a regular file has, so that its end is seen in the first round.
  std::size_t room = S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) + 1 : 65536;
  std::string bytes;
  for (std::size_t size = 0;; room = 2 * size) {
    if (room > maximum_file_size)
      throw Read_error(path, 0, "is larger than 16 GiB, the limit for files");
    bytes.resize(room);
    size += input.read(bytes.data() + size, room - size);
    if (size < room) {
      bytes.resize(size);
      break;
    }
  }
  if (bytes.empty()) throw Read_error(path, 0, "is empty, wanted " + wanted);
  return bytes;
}

}  // namespace conformal
