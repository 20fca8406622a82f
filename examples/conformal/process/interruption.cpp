// Copyright (c) 2026 The Conformal Geometry Processing authors
// SPDX-License-Identifier: LGPL-3.0-or-later
#include "interruption.h"

#include "Failure.h"

#include "conformal/io/file/Temporary_file.h"

#include <unistd.h>

#include <csignal>

namespace conformal {
namespace {

volatile std::sig_atomic_t received = 0, is_patient = 0;

[[noreturn]] void end_at_once(int number)
{
  remove_temporary_files();
  ::_exit(128 + number);
}

// A factorization cannot be asked to end: the alarm does that where it takes too long.
extern "C" void on_signal(int number)
{
  if (number == SIGALRM || received != 0) end_at_once(received != 0 ? received : number);
  received = number;
  if (is_patient == 0) ::alarm(1);
}

}  // namespace

void listen_to_signals()
{
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGALRM})
    ::sigaction(number, &action, nullptr);
  for (const int number : {SIGPIPE, SIGXFSZ}) std::signal(number, SIG_IGN);
}

int signal_received()
{
  return received;
}

Patience::Patience()
{
  is_patient = 1;
  ::alarm(0);  // of a signal that has just come
}

Patience::~Patience()
{
  is_patient = 0;
  if (received != 0) ::alarm(1);
}

void throw_if_interrupted(const std::string& consequence)
{
  if (received == 0) return;
  throw Failure(received == SIGINT ? Exit_code::interrupted : Exit_code::terminated,
                "interrupted; " + consequence);
}

}  // namespace conformal
