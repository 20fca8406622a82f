// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "Temporary_file.h"

#include "io_errors.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>

namespace conformal {
namespace {

// The register of temporaries: plain memory and lock-free flags, for a signal handler reads it.
enum Slot_state { vacant, being_filled, filled };
struct Slot {
  std::atomic<int> state{vacant};
  std::array<char, PATH_MAX> path{};
};
constexpr std::size_t slots = 16;
std::array<Slot, slots> registered;
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may not wait for a lock");

// The slot that the path went into, or `slots` if the path is too long or no slot is vacant.
std::size_t enter(const std::string& path)
{
  if (path.size() >= PATH_MAX) return slots;
  for (std::size_t i = 0; i < slots; ++i) {
    int expected = vacant;
    if (!registered[i].state.compare_exchange_strong(expected, being_filled)) continue;
    std::memcpy(registered[i].path.data(), path.c_str(), path.size() + 1);
    registered[i].state = filled;
    return i;
  }
  return slots;
}

void leave(std::size_t slot)
{
  if (slot < slots) registered[slot].state = vacant;
}

std::atomic<Listener_to_written_files> listener{nullptr};
std::atomic<bool> is_renaming{false};

void tell_written(const std::string& path)
{
  if (const Listener_to_written_files tell = listener) tell(path);
}

std::string folder_of(const std::string& path)
{
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "./" : path.substr(0, slash + 1);
}

// the file that a path stands for, through symbolic links if it exists
std::string resolved(const std::string& path)
{
  char* real = ::realpath(path.c_str(), nullptr);
  if (real == nullptr) return path;
  const std::string result = real;
  std::free(real);
  return result;
}

// by which a file without a name can be given one
std::string path_of_open(int file)
{
  return "/proc/self/fd/" + std::to_string(file);
}

// The reader of a pipe, such as `head`, may end before all is written.
bool is_pipe_of_standard_output(int file)
{
  struct stat own {
  }, standard{};
  return ::fstat(file, &own) == 0 && ::fstat(STDOUT_FILENO, &standard) == 0 &&
         (S_ISFIFO(own.st_mode) || S_ISSOCK(own.st_mode)) && own.st_dev == standard.st_dev &&
         own.st_ino == standard.st_ino;
}

bool is_unsupported(int error)
{
  return error == EINVAL || error == ENOTSUP || error == ENOSYS;
}

}  // namespace

Temporary_file::Temporary_file(const std::string& target, Name name)
    : m_target(target), m_path(resolved(target)), m_slot(slots)
{
  if (target.empty()) throw Write_error(target, "no name, wanted a file");
  struct stat status {
  }, link{};
  const bool exists = ::stat(m_path.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) throw Write_error(m_target, "is a directory");
  if (exists && ::access(m_path.c_str(), W_OK) != 0) fail("cannot be replaced");
  if (!exists && ::lstat(m_path.c_str(), &link) == 0)
    throw Write_error(m_target, "is a symbolic link to a file that does not exist");
  if (exists && !S_ISREG(status.st_mode)) {
    m_is_direct = true;
    m_file = ::open(m_path.c_str(), O_WRONLY | O_CLOEXEC);
    if (m_file < 0) fail("cannot be opened");
    return;
  }
  if (name == Name::if_necessary) open_nameless();
  if (m_file < 0)
    create_named(
        [this](const char* path) {
          m_file = ::open(path, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
          return m_file >= 0;
        },
        "cannot be written in its folder");
  if (exists) take_after(status);
}

Temporary_file::~Temporary_file()
{
  if (m_file >= 0) ::close(m_file);
  if (!m_temporary.empty()) ::unlink(m_temporary.c_str());
  leave(m_slot);
}

// The mode after the owner, whose change takes rights away. Where the mode cannot be kept, the
// default one does no harm.
void Temporary_file::take_after(const struct stat& old)
{
  struct stat own {};
  const bool is_same =
      ::fstat(m_file, &own) == 0 && own.st_uid == old.st_uid && own.st_gid == old.st_gid;
  m_changes_owner = !is_same && ::fchown(m_file, old.st_uid, old.st_gid) != 0;
  static_cast<void>(::fchmod(m_file, old.st_mode & 07777));
}

void Temporary_file::open_nameless()
{
#ifdef O_TMPFILE
  m_file = ::open(folder_of(m_path).c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
  if (m_file < 0 || ::access(path_of_open(m_file).c_str(), F_OK) == 0) return;
  ::close(m_file);
  m_file = -1;
#endif
}

// `create` makes a file of a new name, and is false if it cannot.
template <class Create>
void Temporary_file::create_named(const Create& create, const std::string& fault)
{
  static std::atomic<unsigned> counter{0};
  const std::string stem = folder_of(m_path) + ".conformal-" + std::to_string(::getpid()) + '-';
  bool is_created = false;
  do {
    leave(m_slot);
    const std::string path = stem + std::to_string(counter++) + ".tmp";
    m_slot = enter(path);  // before it exists: a signal may come at once
    is_created = create(path.c_str());
    if (is_created) m_temporary = path;
  } while (!is_created && errno == EEXIST);
  if (is_created) return;
  const int error = errno;
  leave(m_slot);
  errno = error;
  fail(fault);
}

void Temporary_file::write(std::string_view bytes)
{
  if (m_is_direct) tell_written(m_target);
  while (!bytes.empty()) {
    const ssize_t n = ::write(m_file, bytes.data(), std::min(bytes.size(), std::size_t{1} << 30));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0 && errno == EPIPE && is_pipe_of_standard_output(m_file)) return;
    if (n < 0) fail("cannot be written");
    bytes.remove_prefix(static_cast<std::size_t>(n));
  }
}

std::optional<std::string> Temporary_file::read_back() const
{
  if (m_is_direct) return {};
  struct stat status {};
  if (::fstat(m_file, &status) != 0) fail("cannot be examined");
  std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
  for (std::size_t done = 0; done < bytes.size();) {
    const std::size_t size = std::min(bytes.size() - done, std::size_t{1} << 30);
    const ssize_t n = ::pread(m_file, bytes.data() + done, size, static_cast<off_t>(done));
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) fail("cannot be read again");
    done += static_cast<std::size_t>(n);
  }
  return bytes;
}

void Temporary_file::commit()
{
  if (::fsync(m_file) != 0 && !is_unsupported(errno)) fail("cannot be brought to the disk");
  if (m_temporary.empty() && !m_is_direct)
    create_named(
        [this](const char* path) {
          return ::linkat(AT_FDCWD, path_of_open(m_file).c_str(), AT_FDCWD, path,
                          AT_SYMLINK_FOLLOW) == 0;
        },
        "cannot be named");
  close_file();
  if (m_is_direct) return;
  rename();
  m_temporary.clear();
  leave(m_slot);
  m_slot = slots;
  flush_folder();
}

// A signal handler that ends the program between the two would tell what is not true.
void Temporary_file::rename()
{
  is_renaming = true;
  const bool is_renamed = ::rename(m_temporary.c_str(), m_path.c_str()) == 0;
  const int error = errno;
  if (is_renamed) tell_written(m_target);
  is_renaming = false;
  errno = error;
  if (!is_renamed) fail("cannot be replaced");
}

void Temporary_file::close_file()
{
  const int file = m_file;
  m_file = -1;
  if (::close(file) != 0) fail("cannot be closed");
}

// The new name survives a power cut; where folders cannot be flushed, the file is still complete.
void Temporary_file::flush_folder() const
{
  const int folder = ::open(folder_of(m_path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return;
  static_cast<void>(::fsync(folder));
  ::close(folder);
}

void Temporary_file::fail(const std::string& what) const
{
  throw Write_error(m_target, what + ": " + std::strerror(errno));
}

void tell_written_files_to(Listener_to_written_files own) noexcept
{
  listener = own;
}

bool is_renaming_file() noexcept
{
  return is_renaming;
}

void remove_temporary_files() noexcept
{
  for (Slot& slot : registered)
    if (slot.state == filled) ::unlink(slot.path.data());
}

void write_file(const std::string& path, std::string_view bytes)
{
  Temporary_file file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace conformal
