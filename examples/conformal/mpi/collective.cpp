// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "collective.h"

#include "conformal/process/Failure.h"
#include "conformal/run.h"

#include <utility>

namespace conformal::mpi {
namespace {

/// the text of a process
std::string text_of_process(std::string text, int process)
{
  int size = static_cast<int>(text.size());
  MPI_Bcast(&size, 1, MPI_INT, process, MPI_COMM_WORLD);
  text.resize(static_cast<std::size_t>(size));
  MPI_Bcast(text.data(), size, MPI_CHAR, process, MPI_COMM_WORLD);
  return text;
}

std::vector<int> offsets_of(const std::vector<int>& counts)
{
  std::vector<int> offsets(counts.size(), 0);
  for (std::size_t p = 1; p < counts.size(); ++p) offsets[p] = offsets[p - 1] + counts[p - 1];
  return offsets;
}

}  // namespace

int rank()
{
  int r = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &r);
  return r;
}

int processes()
{
  int n = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &n);
  return n;
}

void together(const std::function<void()>& work)
{
  const Ending mine = carry_out(work);
  int first = mine.code == Exit_code::done ? processes() : rank();
  MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  if (first == processes()) return;
  int code = static_cast<int>(mine.code);
  MPI_Bcast(&code, 1, MPI_INT, first, MPI_COMM_WORLD);
  throw Failure(static_cast<Exit_code>(code), text_of_process(mine.error, first));
}

double sum(double value)
{
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return value;
}

std::size_t sum(std::size_t value)
{
  unsigned long long all = value;
  MPI_Allreduce(MPI_IN_PLACE, &all, 1, MPI_UNSIGNED_LONG_LONG, MPI_SUM, MPI_COMM_WORLD);
  return static_cast<std::size_t>(all);
}

double largest(double value)
{
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return value;
}

std::vector<double> of_each(double value)
{
  std::vector<double> values(static_cast<std::size_t>(processes()));
  MPI_Allgather(&value, 1, MPI_DOUBLE, values.data(), 1, MPI_DOUBLE, MPI_COMM_WORLD);
  return values;
}

std::string broadcast(std::string text)
{
  return text_of_process(std::move(text), 0);
}

bool broadcast(bool value)
{
  int answer = value ? 1 : 0;
  MPI_Bcast(&answer, 1, MPI_INT, 0, MPI_COMM_WORLD);
  return answer != 0;
}

std::vector<std::byte> deliver_bytes(const std::vector<std::vector<std::byte>>& to,
                                     std::size_t size, std::vector<int>& counts)
{
  std::vector<int> sent;
  std::vector<std::byte> out;
  for (const std::vector<std::byte>& part : to) {
    sent.push_back(static_cast<int>(part.size() / size));
    out.insert(out.end(), part.begin(), part.end());
  }
  counts.resize(sent.size());
  MPI_Alltoall(sent.data(), 1, MPI_INT, counts.data(), 1, MPI_INT, MPI_COMM_WORLD);
  MPI_Datatype type = MPI_DATATYPE_NULL;
  MPI_Type_contiguous(static_cast<int>(size), MPI_BYTE, &type);
  MPI_Type_commit(&type);
  const std::vector<int> from = offsets_of(sent), at = offsets_of(counts);
  std::vector<std::byte> in(size * static_cast<std::size_t>(at.back() + counts.back()));
  MPI_Alltoallv(out.data(), sent.data(), from.data(), type, in.data(), counts.data(), at.data(),
                type, MPI_COMM_WORLD);
  MPI_Type_free(&type);
  return in;
}

Ranges Ranges::equal(int total)
{
  Ranges ranges;
  const int n = processes();
  for (int p = 0; p <= n; ++p)
    ranges.first.push_back(static_cast<int>(static_cast<long long>(total) * p / n));
  return ranges;
}

Ranges Ranges::of(int mine)
{
  Ranges ranges{{0}};
  for (const double size : of_each(mine))
    ranges.first.push_back(ranges.first.back() + static_cast<int>(size));
  return ranges;
}

}  // namespace conformal::mpi
