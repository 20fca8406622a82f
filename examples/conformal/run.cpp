// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "run.h"

#include "Command_line.h"
#include "output_names.h"

#include "conformal/io/file/Temporary_file.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/process/Failure.h"
#include "conformal/process/interruption.h"
#include "conformal/process/memory.h"
#include "conformal/process/text.h"
#include "conformal/process/threads.h"
#include "conformal/report/Report_files.h"
#include "conformal/report/Session.h"

#include <Quaternionic_linear_algebra/exceptions.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>

namespace conformal {
namespace {

Ending ending_of(const CGP::Solver_error& error, const std::string& where)
{
  if (CGP::is_out_of_memory(error))
    return {Exit_code::out_of_memory, where + error.message() + ": " + why_memory_is_out()};
  return {Exit_code::failed,
          where + error.message() + "; try: less of a change, or a mesh without slivers"};
}

}  // namespace

Ending ending_of_exception(const std::string& input)
{
  const std::string where = input.empty() ? "" : input + ": ";
  try {
    throw;
  } catch (const Failure& failure) {
    return {failure.code(), failure.what()};
  } catch (const Read_error& error) {
    return {Exit_code::unreadable, error.what()};
  } catch (const Write_error& error) {
    return {Exit_code::unwritable, error.what()};
  } catch (const CGP::Solver_error& error) {
    return ending_of(error, where);
  } catch (const CGP::Precondition_error& error) {
    return {Exit_code::unsuitable, where + error.message()};
  } catch (const std::bad_alloc&) {
    return {Exit_code::out_of_memory, why_memory_is_out()};
  } catch (const std::exception& error) {
    return {Exit_code::failed, error.what()};
  }
}

namespace {

// A reader such as `head` that ends early has had what it wanted, and that is not an error; the
// rest goes nowhere.
void print(const std::string& text)
{
  errno = 0;
  const std::size_t size = std::fwrite(text.data(), 1, text.size(), stdout);
  if (size == text.size() && std::fflush(stdout) == 0) return;
  if (errno != EPIPE) throw Write_error("standard output", "cannot be written");
  [[maybe_unused]] const std::FILE* const nowhere = std::freopen("/dev/null", "w", stdout);
}

// Also what a command has told before it failed.
void print_tables(Session& session)
{
  if (!session.options().quiet) print(printable(session.report().text()));
}

bool is_interrupted(const Ending& ending)
{
  return ending.code >= Exit_code::interrupted;
}

Ending run_command(const Command_line& line)
{
  Session session(line.common);
  session.outcome().command = line.command->name;
  session.report() = line.options;
  Report_files files;
  const auto work = [&] {
    require_separate_outputs(line);
    files.open(line.common);
    line.command->run(session);
  };
  Ending ending = carry_out(work, session.input());
  const Ending printed = carry_out([&] { print_tables(session); });
  if (ending.code == Exit_code::done) ending = printed;
  if (is_interrupted(ending) && !session.keeps_report()) return ending;
  const Outcome& outcome = session.finished(is_interrupted(ending) ? "" : ending.error);
  const Ending written = carry_out([&] { files.write(outcome); });
  if (ending.code == Exit_code::done) ending = written;
  // A signal may have come while the last of the outputs was written.
  if (ending.code == Exit_code::done && has_written())
    ending = carry_out([] { throw_if_interrupted(); });
  return ending.code == Exit_code::done ? outcome.ending() : ending;
}

Ending parse_and_run(int argc, const char* const* argv)
{
  Command_line line;
  Ending ending = carry_out([&] { line = parse_command_line(argc, argv); });
  if (ending.code != Exit_code::done) return ending;
  if (line.command) {
    limit_memory(line.common.max_memory);
    set_threads(line.common.threads);
    return run_command(line);
  }
  return carry_out([&] { print(line.answer); });
}

// Allocates nothing.
int tell_that_memory_is_out()
{
  std::fprintf(stderr, "conformal: error: %s\n", why_memory_is_out());
  return static_cast<int>(Exit_code::out_of_memory);
}

// Exceptions end here where a library promises not to throw, and allocates all the same.
[[noreturn]] void on_terminate()
{
  remove_temporary_files();
  try {
    if (const std::exception_ptr error = std::current_exception()) std::rethrow_exception(error);
  } catch (const std::bad_alloc&) {
    ::_exit(tell_that_memory_is_out());
  } catch (...) {  // nothing is known of it
  }
  std::abort();
}

// Threads of the BLAS that wait for memory are not waited for.
[[noreturn]] void end_at_once(Exit_code code)
{
  std::fflush(nullptr);
  ::_exit(static_cast<int>(code));
}

// An output file must not get the number of a standard stream that was closed.
void open_standard_streams()
{
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) == -1 && ::open("/dev/null", O_RDWR) == -1) return;
}

}  // namespace

int run(int argc, const char* const* argv)
{
  open_standard_streams();
  listen_to_signals();
  std::set_terminate(on_terminate);
  try {
    const Ending ending = parse_and_run(argc, argv);
    if (ending.code != Exit_code::done)
      std::fprintf(stderr, "conformal: error: %s\n", printable_line(ending.error).c_str());
    if (ending.code == Exit_code::out_of_memory) end_at_once(ending.code);
    return static_cast<int>(ending.code);
  } catch (const std::bad_alloc&) {  // before, or while, there is an outcome
    tell_that_memory_is_out();
    end_at_once(Exit_code::out_of_memory);
  }
}

}  // namespace conformal
