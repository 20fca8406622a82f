// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include "versions.h"

#include <Conformal_geometry_processing/version.h>
#include <Quaternionic_linear_algebra/settings.h>

#include <CGAL/version.h>
#include <Eigen/Core>

#ifdef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
#include <cholmod.h>
#endif
#include <dlfcn.h>

#include <climits>
#include <cstdlib>

namespace conformal {

namespace CGP = Conformal_geometry_processing;

namespace {

std::string dotted(int major, int minor, int patch)
{
  return std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(patch);
}

std::string cholmod()
{
#ifdef CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD
  int version[3];
  cholmod_version(version);
  return dotted(version[0], version[1], version[2]);
#else
  return "not used";
#endif
}

// OpenBLAS reports its version; for any other BLAS only the file is known.
std::string blas()
{
  if (void* const function = ::dlsym(RTLD_DEFAULT, "openblas_get_config"))
    return reinterpret_cast<char* (*)()>(function)();
  Dl_info library{};
  void* const function = ::dlsym(RTLD_DEFAULT, "dgemm_");
  if (function == nullptr || ::dladdr(function, &library) == 0) return "none";
  char* const path = ::realpath(library.dli_fname, nullptr);
  const std::string name = path != nullptr ? path : library.dli_fname;
  std::free(path);
  return name;
}

}  // namespace

std::string versions()
{
  return "conformal " CONFORMAL_GEOMETRY_PROCESSING_VERSION "\nCGAL " CGAL_VERSION_STR "\nEigen " +
         dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION) + "\nCHOLMOD " +
         cholmod() + "\nBLAS " + blas() + "\nvector unit " + CGP::to_string(CGP::vector_unit()) +
         '\n';
}

}  // namespace conformal
