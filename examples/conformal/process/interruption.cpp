// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "interruption.h"

#include "Failure.h"
#include "Signal_text.h"
#include "status_line.h"
#include "text.h"

#include "conformal/io/file/Temporary_file.h"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <vector>

namespace conformal {
namespace {

constexpr unsigned seconds_to_end = 1, seconds_between_lines = 10;

volatile std::sig_atomic_t received = 0, is_patient = 0, is_forced = 0;
volatile std::sig_atomic_t has_terminal = 0;  // on which a line of progress may stand
Signal_text written;                          // empty: nothing

std::string sentence_of(const std::vector<std::string>& files)
{
  constexpr std::size_t most = 3;
  if (files.size() > most)
    return std::to_string(files.size()) + " files were written, the last is " + files.back();
  std::string list;
  for (const std::string& file : files) list += (list.empty() ? "" : ", ") + file;
  return list + (files.size() == 1 ? " was written" : " were written");
}

void keep_sentence(const std::string& path)
{
  static std::vector<std::string> files;
  const std::string name = printable_line(path);
  if (files.empty() || files.back() != name) files.push_back(name);
  written.set(sentence_of(files));
}

[[noreturn]] void end_at_once(int number)
{
  remove_temporary_files();
  if (has_terminal != 0) write_to_stderr("\r\033[K");
  write_to_stderr("conformal: error: interrupted; ");
  write_to_stderr(what_was_written());
  write_to_stderr("\n");
  ::_exit(128 + number);
}

// A factorization cannot be asked to end: the alarm does that where it takes too long. Until then
// it tells that the work goes on.
void on_alarm()
{
  const bool ends = received != 0 && (is_patient == 0 || is_forced != 0);
  if (ends && !is_renaming_file()) end_at_once(received);
  if (!ends) write_status();
  ::alarm(ends ? seconds_to_end : seconds_between_lines);
}

void on_request_to_end(int number)
{
  is_forced = received != 0;
  if (is_forced != 0 && !is_renaming_file()) end_at_once(received);
  if (received == 0) received = number;
  if (is_patient == 0 || is_forced != 0) ::alarm(seconds_to_end);
}

extern "C" void on_signal(int number)
{
  const int error = errno;
  if (number == SIGALRM)
    on_alarm();
  else
    on_request_to_end(number);
  errno = error;
}

}  // namespace

void listen_to_signals()
{
  has_terminal = ::isatty(STDERR_FILENO);
  tell_written_files_to(keep_sentence);
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) ::sigaction(number, &action, nullptr);
  action.sa_flags = SA_RESTART;
  ::sigaction(SIGALRM, &action, nullptr);
  for (const int number : {SIGPIPE, SIGXFSZ}) std::signal(number, SIG_IGN);
  ::alarm(seconds_between_lines);
}

int signal_received()
{
  return received;
}

const char* what_was_written() noexcept
{
  return has_written() ? written.get() : "nothing was written";
}

bool has_written() noexcept
{
  return written.get()[0] != '\0';
}

Patience::Patience()
{
  is_patient = 1;
}

Patience::~Patience()
{
  is_patient = 0;
  if (received != 0) ::alarm(seconds_to_end);
}

void throw_if_interrupted(const std::string& consequence)
{
  if (received == 0) return;
  throw Failure(received == SIGINT ? Exit_code::interrupted : Exit_code::terminated,
                "interrupted; " + consequence);
}

}  // namespace conformal
