// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "threads.h"

#include <Quaternionic_linear_algebra/threads/Thread_team.h>

#include <dlfcn.h>

namespace conformal {

void set_threads(int count)
{
  Conformal_geometry_processing::set_number_of_threads(count);
  // Which BLAS there is shows at run time: Debian lets the user choose.
  for (const char* name : {"openblas_set_num_threads", "omp_set_num_threads",
                           "bli_thread_set_num_threads", "MKL_Set_Num_Threads"}) {
    void* const function = ::dlsym(RTLD_DEFAULT, name);
    if (function != nullptr) reinterpret_cast<void (*)(int)>(function)(count);
  }
}

}  // namespace conformal
