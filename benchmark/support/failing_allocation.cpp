// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
//
// To be preloaded (LD_PRELOAD): the allocation of number FAIL_ALLOCATION fails, once; they are
// counted from the begin of main(), for before it nobody can handle a failure. Without the variable
// all succeed, and the count goes to the file COUNT_ALLOCATIONS when the program ends.
#include <dlfcn.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
}

namespace {

std::atomic<long> count{0}, failing{0};

bool fails()
{
  if (++count != failing) return false;
  errno = ENOMEM;
  return true;
}

using Main = int (*)(int, char**, char**);
Main program_main = nullptr;

int counted_main(int argc, char** argv, char** environment)
{
  const char* const number = std::getenv("FAIL_ALLOCATION");
  failing = number != nullptr ? std::atol(number) : 0;
  count = 0;
  return program_main(argc, argv, environment);
}

[[gnu::destructor]] void end()
{
  const char* const path = std::getenv("COUNT_ALLOCATIONS");
  const long total = count;
  if (std::FILE* const file = path != nullptr ? std::fopen(path, "w") : nullptr) {
    std::fprintf(file, "%ld\n", total);
    std::fclose(file);
  }
}

}  // namespace

extern "C" {

int __libc_start_main(Main entry, int argc, char** argv, void (*begin)(), void (*end)(),
                      void (*unload)(), void* stack)
{
  using Start = int (*)(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
  const auto start = reinterpret_cast<Start>(::dlsym(RTLD_NEXT, "__libc_start_main"));
  program_main = entry;
  return start(counted_main, argc, argv, begin, end, unload, stack);
}

void* malloc(std::size_t size)
{
  return fails() ? nullptr : __libc_malloc(size);
}

void* calloc(std::size_t number, std::size_t size)
{
  return fails() ? nullptr : __libc_calloc(number, size);
}

void* realloc(void* old, std::size_t size)
{
  return fails() ? nullptr : __libc_realloc(old, size);
}

void* memalign(std::size_t alignment, std::size_t size)
{
  return fails() ? nullptr : __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size)
{
  return memalign(alignment, size);
}

int posix_memalign(void** result, std::size_t alignment, std::size_t size)
{
  *result = memalign(alignment, size);
  return *result == nullptr ? ENOMEM : 0;
}
}
