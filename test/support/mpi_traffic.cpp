// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Loaded before MPI (LD_PRELOAD), counts what each process receives: in its working directory,
// traffic.RANK has the bytes of the largest call, and of all together, when MPI ends.
#include <mpi.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace {

double largest = 0, total = 0;

double bytes_of(double count, MPI_Datatype type)
{
  int size = 0;
  PMPI_Type_size(type, &size);
  return count * size;
}

/// what the call has received, with the result of the call
int received(double bytes, int result)
{
  largest = std::max(largest, bytes);
  total += bytes;
  return result;
}

int size_of(MPI_Comm comm)
{
  int n = 1;
  PMPI_Comm_size(comm, &n);
  return n;
}

int rank_in(MPI_Comm comm)
{
  int r = 0;
  PMPI_Comm_rank(comm, &r);
  return r;
}

double sum(const int* counts, MPI_Comm comm)
{
  double all = 0;
  for (int p = 0; p < size_of(comm); ++p) all += counts[p];
  return all;
}

}  // namespace

extern "C" {

int MPI_Recv(void* to, int n, MPI_Datatype t, int from, int tag, MPI_Comm comm, MPI_Status* status)
{
  return received(bytes_of(n, t), PMPI_Recv(to, n, t, from, tag, comm, status));
}

int MPI_Irecv(void* to, int n, MPI_Datatype t, int from, int tag, MPI_Comm comm, MPI_Request* r)
{
  return received(bytes_of(n, t), PMPI_Irecv(to, n, t, from, tag, comm, r));
}

int MPI_Bcast(void* data, int n, MPI_Datatype t, int root, MPI_Comm comm)
{
  return received(bytes_of(n, t), PMPI_Bcast(data, n, t, root, comm));
}

int MPI_Allreduce(const void* from, void* to, int n, MPI_Datatype t, MPI_Op op, MPI_Comm comm)
{
  return received(bytes_of(n, t), PMPI_Allreduce(from, to, n, t, op, comm));
}

int MPI_Gatherv(const void* from, int n, MPI_Datatype t, void* to, const int* counts,
                const int* offsets, MPI_Datatype type, int root, MPI_Comm comm)
{
  const double bytes = rank_in(comm) == root ? bytes_of(sum(counts, comm), type) : 0;
  return received(bytes, PMPI_Gatherv(from, n, t, to, counts, offsets, type, root, comm));
}

int MPI_Allgather(const void* from, int n, MPI_Datatype t, void* to, int m, MPI_Datatype type,
                  MPI_Comm comm)
{
  return received(bytes_of(1. * m * size_of(comm), type),
                  PMPI_Allgather(from, n, t, to, m, type, comm));
}

int MPI_Allgatherv(const void* from, int n, MPI_Datatype t, void* to, const int* counts,
                   const int* offsets, MPI_Datatype type, MPI_Comm comm)
{
  return received(bytes_of(sum(counts, comm), type),
                  PMPI_Allgatherv(from, n, t, to, counts, offsets, type, comm));
}

int MPI_Alltoallv(const void* from, const int* sent, const int* begins, MPI_Datatype t, void* to,
                  const int* counts, const int* offsets, MPI_Datatype type, MPI_Comm comm)
{
  return received(bytes_of(sum(counts, comm), type),
                  PMPI_Alltoallv(from, sent, begins, t, to, counts, offsets, type, comm));
}

int MPI_Finalize()
{
  std::ofstream("traffic." + std::to_string(rank_in(MPI_COMM_WORLD))) << largest << " " << total;
  return PMPI_Finalize();
}

}  // extern "C"
