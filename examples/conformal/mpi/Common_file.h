// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "collective.h"

#include "conformal/io/file/io_errors.h"

#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

namespace conformal::mpi {

/// A file that all processes write, each at its own places; it has another name until `commit()`.
class Common_file {
 public:
  explicit Common_file(const std::string& path) : m_path(path), m_temporary(path + ".part")
  {
    check(MPI_File_open(MPI_COMM_WORLD, m_temporary.c_str(), MPI_MODE_CREATE | MPI_MODE_WRONLY,
                        MPI_INFO_NULL, &m_file));
    check(MPI_File_set_size(m_file, 0));
  }
  Common_file(const Common_file&) = delete;
  Common_file& operator=(const Common_file&) = delete;
  ~Common_file()
  {
    if (m_file != MPI_FILE_NULL) MPI_File_close(&m_file);
    if (!m_is_complete && rank() == 0) std::remove(m_temporary.c_str());
  }

  // not collective
  void write_at(std::size_t place, const std::vector<char>& bytes)
  {
    MPI_Status status;
    const int code = MPI_File_write_at(m_file, static_cast<MPI_Offset>(place), bytes.data(),
                                       static_cast<int>(bytes.size()), MPI_BYTE, &status);
    if (code != MPI_SUCCESS) throw Write_error(m_path, "writing failed");
  }

  void commit()
  {
    check(MPI_File_sync(m_file));
    check(MPI_File_close(&m_file));
    together([&] {
      if (rank() == 0 && std::rename(m_temporary.c_str(), m_path.c_str()) != 0)
        throw Write_error(m_path, "it cannot get its name");
    });
    m_is_complete = true;
  }

 private:
  void check(int code) const
  {
    together([&] {
      if (code != MPI_SUCCESS) throw Write_error(m_path, "it cannot be written");
    });
  }

  std::string m_path, m_temporary;
  MPI_File m_file = MPI_FILE_NULL;
  bool m_is_complete = false;
};

}  // namespace conformal::mpi
