// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "run.h"

#include "Command_line.h"
#include "output_names.h"

#include "conformal/commands/blend.h"
#include "conformal/commands/boundary.h"
#include "conformal/commands/compare.h"
#include "conformal/commands/curve.h"
#include "conformal/commands/fit.h"
#include "conformal/commands/flatten.h"
#include "conformal/commands/flow.h"
#include "conformal/commands/harmonic.h"
#include "conformal/commands/info.h"
#include "conformal/commands/spectrum.h"
#include "conformal/commands/sphere.h"
#include "conformal/commands/spin.h"
#include "conformal/io/file/Temporary_file.h"
#include "conformal/io/file/io_errors.h"
#include "conformal/process/Failure.h"
#include "conformal/process/interruption.h"
#include "conformal/process/threads.h"
#include "conformal/report/Report_files.h"
#include "conformal/report/Session.h"

#include <Conformal_geometry_processing/exceptions.h>

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <new>

namespace conformal {
namespace {

const char* const no_memory = "out of memory; try: a coarser mesh";

struct Outcome {
  Exit_code code = Exit_code::done;
  std::string error;
};

Outcome outcome_of(const CGP::Solver_error& error)
{
  if (CGP::is_out_of_memory(error))
    return {Exit_code::out_of_memory, error.message() + "; try: a coarser mesh"};
  return {Exit_code::failed,
          error.message() + "; try: less of a change, or a mesh without slivers"};
}

Outcome carry_out(const std::function<void()>& work)
{
  try {
    work();
    return {};
  } catch (const Failure& failure) {
    return {failure.code(), failure.what()};
  } catch (const Read_error& error) {
    return {Exit_code::unreadable, error.what()};
  } catch (const Write_error& error) {
    return {Exit_code::unwritable, error.what()};
  } catch (const CGP::Solver_error& error) {
    return outcome_of(error);
  } catch (const CGP::Precondition_error& error) {
    return {Exit_code::unsuitable, error.message()};
  } catch (const std::bad_alloc&) {
    return {Exit_code::out_of_memory, no_memory};
  } catch (const std::exception& error) {
    return {Exit_code::failed, error.what()};
  }
}

void dispatch(const Command_line& line, Session& session)
{
  if (const auto* options = std::get_if<Info_options>(&line.options)) info(*options, session);
  if (const auto* options = std::get_if<Spin_options>(&line.options)) spin(*options, session);
  if (const auto* options = std::get_if<Flow_options>(&line.options)) flow(*options, session);
  if (const auto* options = std::get_if<Boundary_options>(&line.options))
    boundary(*options, session);
  if (const auto* options = std::get_if<Fit_options>(&line.options)) fit(*options, session);
  if (const auto* options = std::get_if<Blend_options>(&line.options)) blend(*options, session);
  if (const auto* options = std::get_if<Flatten_options>(&line.options)) flatten(*options, session);
  if (const auto* options = std::get_if<Curve_options>(&line.options)) curve(*options, session);
  if (const auto* options = std::get_if<Harmonic_options>(&line.options))
    harmonic(*options, session);
  if (const auto* options = std::get_if<Spectrum_options>(&line.options))
    spectrum(*options, session);
  if (const auto* options = std::get_if<Sphere_options>(&line.options)) sphere(*options, session);
  if (const auto* options = std::get_if<Compare_options>(&line.options)) compare(*options, session);
}

// Adds the file name, which errors of the library do not contain.
void dispatch_with_name(const Command_line& line, Session& session)
{
  try {
    dispatch(line, session);
  } catch (const CGP::Precondition_error& error) {
    if (session.input().empty()) throw;
    throw unsuitable(session.input(), error.message());
  } catch (const CGP::Solver_error& error) {
    if (session.input().empty()) throw;
    const Outcome outcome = outcome_of(error);
    throw Failure(outcome.code, session.input() + ": " + outcome.error);
  }
}

void flush_output()
{
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw Write_error("standard output", "cannot be written");
}

Outcome run_command(const Command_line& line)
{
  Session session(line.common, line.command);
  Report_files files;
  Outcome outcome = carry_out([&] {
    require_separate_outputs(line);
    files.open(line.common);
    dispatch_with_name(line, session);
    flush_output();
  });
  const bool is_interrupted = outcome.code >= Exit_code::interrupted;
  if (is_interrupted && !session.keeps_report()) return outcome;
  const Outcome written =
      carry_out([&] { files.write(session, is_interrupted ? "" : outcome.error); });
  return outcome.code == Exit_code::done ? written : outcome;
}

Outcome parse_and_run(int argc, const char* const* argv)
{
  Command_line line;
  Outcome outcome = carry_out([&] { line = parse_command_line(argc, argv); });
  if (outcome.code != Exit_code::done) return outcome;
  if (line.answer.empty()) {
    set_threads(line.common.threads);
    return run_command(line);
  }
  return carry_out([&] {
    std::fputs(line.answer.c_str(), stdout);
    flush_output();
  });
}

// A message is one line whatever the name of a file is.
std::string on_one_line(std::string text)
{
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  return text;
}

// Allocates nothing.
int tell_that_memory_is_out()
{
  std::fprintf(stderr, "conformal: error: %s\n", no_memory);
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

}  // namespace

int run(int argc, const char* const* argv)
{
  listen_to_signals();
  std::set_terminate(on_terminate);
  try {
    const Outcome outcome = parse_and_run(argc, argv);
    if (outcome.code != Exit_code::done)
      std::fprintf(stderr, "conformal: error: %s\n", on_one_line(outcome.error).c_str());
    return static_cast<int>(outcome.code);
  } catch (const std::bad_alloc&) {  // before, or while, there is an outcome
    return tell_that_memory_is_out();
  }
}

}  // namespace conformal
