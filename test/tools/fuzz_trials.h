// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

// Trials by the thousand, in a child process that is replaced when it dies. Trials are numbered,
// and all that is done in one follows from its number and the seed.

namespace fuzz {

constexpr std::size_t max_outcomes = 8;

/// The request on the command line: [MUTANTS [SEED [SECONDS]]]
struct Request {
  unsigned long mutants = 10000;
  std::uint64_t seed = 1;
  unsigned seconds = 20;
};

inline Request requested(int argc, char** argv)
{
  Request request;
  if (argc > 1) request.mutants = std::strtoul(argv[1], nullptr, 10);
  if (argc > 2) request.seed = std::strtoull(argv[2], nullptr, 10);
  if (argc > 3) request.seconds = static_cast<unsigned>(std::strtoul(argv[3], nullptr, 10));
  return request;
}

/// The operation under test: `run(number, mutant)` returns the index of the outcome, and does not
/// return if an invariant is violated.
struct Subject {
  std::string name;       ///< of the row
  std::string extension;  ///< of the files that are kept
  std::function<std::string(unsigned long)> mutant;
  std::function<std::size_t(unsigned long, const std::string&)> run;
  std::function<std::string(unsigned long)> what;  ///< describes the operation, for the user
};

/// Says which law the program has broken, and ends the process.
[[noreturn]] inline void broken(const std::string& law)
{
  std::fprintf(stderr, "fuzz: %s\n", law.c_str());
  std::abort();
}

inline void require(bool condition, const std::string& law)
{
  if (!condition) broken(law);
}

/// Ends this process, by a signal that the program under test does not catch, unless it is set anew
/// in time.
class Deadline {
 public:
  Deadline(unsigned seconds, int signal)
  {
    sigevent event{};
    event.sigev_notify = SIGEV_SIGNAL;
    event.sigev_signo = signal;
    require(::timer_create(CLOCK_MONOTONIC, &event, &m_timer) == 0, "there is no timer");
    m_limit.it_value.tv_sec = seconds;
  }

  void set() { ::timer_settime(m_timer, 0, &m_limit, nullptr); }

 private:
  timer_t m_timer{};
  itimerspec m_limit{};
};

class Trials {
 public:
  Trials(const Request& request, std::vector<std::string> outcomes)
      : m_request(request), m_outcomes(std::move(outcomes))
  {
    void* shared =
        ::mmap(nullptr, sizeof(Tally), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    require(shared != MAP_FAILED, "there is no memory to share");
    m_tally = static_cast<Tally*>(shared);
    std::string head = "| mutants of";
    for (const std::string& outcome : m_outcomes) head += " | " + outcome;
    std::puts((head + " | crash | hang |").c_str());
    print_rule();
  }

  /// Makes all trials of the subject and prints a row. Mutants that end the process are kept.
  void make(const Subject& subject)
  {
    *m_tally = Tally{};
    unsigned long crashes = 0, hangs = 0;
    while (m_tally->next < m_request.mutants) {
      const int status = status_of_child(subject);
      if (WIFEXITED(status) && WEXITSTATUS(status) == 0) continue;
      ++(WIFSIGNALED(status) && WTERMSIG(status) == SIGVTALRM ? hangs : crashes);
      keep(subject, m_tally->next - 1);
    }
    std::string row = "| " + subject.name;
    for (std::size_t i = 0; i < m_outcomes.size(); ++i)
      row += " | " + std::to_string(m_tally->outcomes[i]);
    std::printf("%s | %lu | %lu |\n", row.c_str(), crashes, hangs);
    std::fflush(stdout);
    m_is_clean = m_is_clean && crashes == 0 && hangs == 0;
  }

  bool is_clean() const { return m_is_clean; }

 private:
  struct Tally {  // in memory that parent and child share
    unsigned long next;
    std::array<unsigned long, max_outcomes> outcomes;
  };

  void print_rule() const
  {
    std::string rule = "| ---";
    for (std::size_t i = 0; i < m_outcomes.size() + 2; ++i) rule += " | --:";
    std::puts((rule + " |").c_str());
    std::fflush(stdout);
  }

  int status_of_child(const Subject& subject)
  {
    const pid_t child = ::fork();
    require(child >= 0, "there is no other process");
    if (child == 0) run(subject);
    int status = 0;
    ::waitpid(child, &status, 0);
    return status;
  }

  // The end by exit() lets a sanitizer look for memory that was lost.
  [[noreturn]] void run(const Subject& subject)
  {
    Deadline deadline(m_request.seconds, SIGVTALRM);
    while (m_tally->next < m_request.mutants) {
      const unsigned long number = m_tally->next++;
      const std::string mutant = subject.mutant(number);
      deadline.set();
      ++m_tally->outcomes[subject.run(number, mutant)];
    }
    deadline.set();
    std::exit(0);
  }

  void keep(const Subject& subject, unsigned long number) const
  {
    const std::string path =
        "fuzz_" + std::to_string(m_request.seed) + '_' + std::to_string(number) + subject.extension;
    std::ofstream(path, std::ios::binary) << subject.mutant(number);
    std::fprintf(stderr, "fuzz: %s %s\n", subject.what(number).c_str(), path.c_str());
  }

  Request m_request;
  std::vector<std::string> m_outcomes;
  Tally* m_tally = nullptr;
  bool m_is_clean = true;
};

}  // namespace fuzz
