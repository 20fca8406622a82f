// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/exceptions.h>

#include <petscksp.h>

#include <complex>
#include <new>
#include <string>
#include <type_traits>
#include <utility>

namespace Conformal_geometry_processing::internal {

static_assert(std::is_same_v<PetscScalar, std::complex<double>>,
              "PETSc must be built for complex numbers of double precision");

// Converts the error code of a PETSc call to an exception.
inline void check_petsc(PetscErrorCode code)
{
  if (code == 0) return;
  if (code == PETSC_ERR_MEM) throw std::bad_alloc();
  const char* kind = nullptr;
  char* what = nullptr;
  PetscErrorMessage(code, &kind, &what);
  std::string message = "error " + std::to_string(code);
  for (const char* part : {kind, static_cast<const char*>(what)})
    if (part != nullptr && *part != '\0') message += std::string(", ") + part;
  throw Solver_error("PETSc", message);
}

// During its lifetime PETSc returns error codes instead of printing messages.
class Quiet_petsc {
 public:
  Quiet_petsc() { PetscPushErrorHandler(PetscReturnErrorHandler, nullptr); }
  Quiet_petsc(const Quiet_petsc&) = delete;
  Quiet_petsc& operator=(const Quiet_petsc&) = delete;
  ~Quiet_petsc() { PetscPopErrorHandler(); }
};

inline bool petsc_is_running()
{
  PetscBool is_initialized = PETSC_FALSE, is_finalized = PETSC_FALSE;
  PetscInitialized(&is_initialized);
  PetscFinalized(&is_finalized);
  return is_initialized && !is_finalized;
}

// Owns a PETSc object. Objects that still exist when PETSc is finalized are not destroyed.
template <class Object, PetscErrorCode (*destroy)(Object*)>
class Petsc_handle {
 public:
  Petsc_handle() = default;
  Petsc_handle(Petsc_handle&& other) noexcept : m_object(std::exchange(other.m_object, nullptr)) {}
  Petsc_handle& operator=(Petsc_handle&& other) noexcept
  {
    std::swap(m_object, other.m_object);
    return *this;
  }
  ~Petsc_handle() { release(); }

  Object get() const { return m_object; }

  // Destroys the object and returns its address, for functions that create a new one
  Object* renew()
  {
    release();
    return &m_object;
  }

 private:
  void release()
  {
    if (m_object != nullptr && petsc_is_running()) destroy(&m_object);
    m_object = nullptr;
  }

  Object m_object = nullptr;
};

using Petsc_vec = Petsc_handle<Vec, VecDestroy>;
using Petsc_mat = Petsc_handle<Mat, MatDestroy>;
using Petsc_scatter = Petsc_handle<VecScatter, VecScatterDestroy>;
using Petsc_pc = Petsc_handle<PC, PCDestroy>;
using Petsc_ksp = Petsc_handle<KSP, KSPDestroy>;

}  // namespace Conformal_geometry_processing::internal
