// Tests examples/conformal/io/file/Temporary_file.cpp
// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "conformal/io/file/Temporary_file.h"

#include "program/io/io_support.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <memory>

namespace cgp_test::temporary_file_tests {

using namespace conformal;
using namespace io_test;

TEST(Temporary_file, appears_only_when_it_is_complete)
{
  const Folder folder;
  const std::string path = folder / "a.ply";
  put_file(path, "old");
  {
    Temporary_file file(path);
    file.write("new ");
    EXPECT_LE(folder.size(), 2u);
    EXPECT_EQ(content(path), "old");
    file.write("content");
    file.commit();
  }
  EXPECT_EQ(content(path), "new content");
  EXPECT_EQ(folder.size(), 1u);
}

TEST(Temporary_file, is_removed_if_it_is_not_committed)
{
  const Folder folder;
  {
    Temporary_file file(folder / "a.ply");
    file.write("half");
    EXPECT_LE(folder.size(), 1u);
  }
  EXPECT_EQ(folder.size(), 0u);
}

TEST(Temporary_file, has_a_name_that_tells_what_it_is)
{
  const Folder folder;
  const Temporary_file file(folder / "a.ply", Temporary_file::Name::at_once);
  const std::string name = std::filesystem::directory_iterator(folder.path())->path().filename();
  EXPECT_EQ(name.rfind(".conformal-" + std::to_string(::getpid()) + '-', 0), 0u) << name;
}

TEST(Temporary_file, can_be_removed_by_a_signal_handler)
{
  const Folder folder;
  const auto at_once = Temporary_file::Name::at_once;
  Temporary_file one(folder / "a.ply", at_once), two(folder / "b.ply", at_once);
  EXPECT_EQ(folder.size(), 2u);
  remove_temporary_files();
  EXPECT_EQ(folder.size(), 0u);
  EXPECT_EQ(message_of<Write_error>([&] { one.commit(); }),
            folder / "a.ply" + ": cannot be replaced: No such file or directory");
}

TEST(Temporary_file, is_removed_when_a_signal_ends_the_program)
{
  const Folder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    ::signal(SIGTERM, [](int) {
      remove_temporary_files();
      ::_exit(7);
    });
    Temporary_file file(folder / "a.ply", Temporary_file::Name::at_once);
    ::raise(SIGTERM);
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_EQ(folder.size(), 0u);
}

TEST(Temporary_file, keeps_the_mode_of_the_old_file_and_symbolic_links)
{
  const Folder folder;
  const std::string path = folder / "a.ply", link = folder / "link.ply";
  put_file(path, "old");
  ::chmod(path.c_str(), 0640);
  std::filesystem::create_symlink("a.ply", link);
  write_file(link, "new");
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(content(path), "new");
  struct stat status {};
  ASSERT_EQ(::stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0640u);
}

TEST(Temporary_file, is_gone_when_the_system_ends_the_program)
{
  const Folder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    Temporary_file file(folder / "a.ply");
    ::raise(SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(folder.size(), 0u);
}

TEST(Temporary_file, is_read_back_as_it_was_written)
{
  const Folder folder;
  for (const auto name : {Temporary_file::Name::at_once, Temporary_file::Name::if_necessary}) {
    Temporary_file file(folder / "a.ply", name);
    file.write("one");
    file.write(std::string(100000, 'x'));
    EXPECT_EQ(file.read_back(), "one" + std::string(100000, 'x'));
    file.commit();
    EXPECT_FALSE(file.changes_owner());
    EXPECT_EQ(content(folder / "a.ply").size(), 100003u);
  }
  EXPECT_EQ(folder.size(), 1u);
  EXPECT_FALSE(Temporary_file("/dev/null").read_back());
}

TEST(Temporary_file, does_not_follow_a_symbolic_link_to_nothing)
{
  const Folder folder;
  std::filesystem::create_symlink("absent.ply", folder / "link.ply");
  EXPECT_EQ(message_of<Write_error>([&] { write_file(folder / "link.ply", "new"); }),
            folder / "link.ply" + ": is a symbolic link to a file that does not exist");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.ply"));
}

TEST(Temporary_file, is_none_where_the_target_is_a_device)
{
  write_file("/dev/null", "anything");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  EXPECT_EQ(message_of<Write_error>([] { write_file("/dev/full", "anything"); }),
            "/dev/full: cannot be written: No space left on device");
}

TEST(Temporary_file, more_than_the_register_holds_are_removed_by_their_destructors)
{
  const Folder folder;
  {
    std::vector<std::unique_ptr<Temporary_file>> files;
    for (int i = 0; i < 40; ++i)
      files.push_back(std::make_unique<Temporary_file>(folder / std::to_string(i),
                                                       Temporary_file::Name::at_once));
    EXPECT_EQ(folder.size(), 40u);
  }
  EXPECT_EQ(folder.size(), 0u);
}

TEST(Temporary_file, leaves_the_old_file_when_the_disk_is_full)
{
  const Folder folder;
  const std::string path = folder / "a.ply";
  put_file(path, "old");
  rlimit old{};
  ::getrlimit(RLIMIT_FSIZE, &old);
  const rlimit small{1000, old.rlim_max};
  ::signal(SIGXFSZ, SIG_IGN);
  ::setrlimit(RLIMIT_FSIZE, &small);
  const std::string message =
      message_of<Write_error>([&] { write_file(path, std::string(2000, 'x')); });
  ::setrlimit(RLIMIT_FSIZE, &old);
  EXPECT_EQ(message, path + ": cannot be written: File too large");
  EXPECT_EQ(content(path), "old");
  EXPECT_EQ(folder.size(), 1u);
}

TEST(Temporary_file, says_why_it_cannot_be_written)
{
  const Folder folder;
  const std::string missing = folder / "missing/a.ply";
  EXPECT_EQ(message_of<Write_error>([&] { write_file(missing, ""); }),
            missing + ": cannot be written in its folder: No such file or directory");
  EXPECT_EQ(message_of<Write_error>([&] { write_file(folder.path().string(), ""); }),
            folder.path().string() + ": is a directory");
  EXPECT_EQ(message_of<Write_error>([&] { write_file("", ""); }), ": no name, wanted a file");
}

}  // namespace cgp_test::temporary_file_tests
