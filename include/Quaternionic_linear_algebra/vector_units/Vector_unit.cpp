// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Quaternionic_linear_algebra/vector_units/Vector_unit.h>

#include <Quaternionic_linear_algebra/vector_units/compiled_kernels.h>

#include <atomic>

namespace Conformal_geometry_processing {
namespace internal {

// The narrowest one where the library has kernels for several, otherwise the one for which
// this file is compiled.
#ifdef CGP_HAS_X86_UNITS
using Library_unit = Baseline_unit;
#else
using Library_unit = Target_unit;
#endif

// Returns whether the machine and its operating system support the unit.
bool machine_has(Vector_unit unit)
{
#ifdef CGP_HAS_X86_UNITS
  __builtin_cpu_init();
  switch (unit) {
    case Vector_unit::avx512:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
             __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
             __builtin_cpu_supports("fma");
    case Vector_unit::avx2:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    case Vector_unit::baseline:
      break;
  }
  return true;
#else
  return unit == Library_unit::unit;
#endif
}

Vector_unit widest_unit()
{
  if (machine_has(Vector_unit::avx512)) return Vector_unit::avx512;
  return machine_has(Vector_unit::avx2) ? Vector_unit::avx2 : Vector_unit::baseline;
}

std::atomic<Vector_unit>& unit_setting()
{
  static std::atomic<Vector_unit> unit{widest_unit()};
  return unit;
}

}  // namespace internal

const char* to_string(internal::Vector_unit unit)
{
  switch (unit) {
    case internal::Vector_unit::avx512:
      return "AVX-512";
    case internal::Vector_unit::avx2:
      return "AVX2";
    case internal::Vector_unit::baseline:
      break;
  }
#if defined(__SSE2__) || defined(_M_X64)
  return "SSE2";
#elif defined(__ARM_NEON) || defined(_M_ARM64)
  return "NEON";
#else
  return "baseline";
#endif
}

bool has_vector_unit(internal::Vector_unit unit)
{
  return internal::machine_has(unit);
}

internal::Vector_unit vector_unit()
{
  return internal::unit_setting();
}

bool set_vector_unit(internal::Vector_unit unit)
{
  if (!has_vector_unit(unit)) return false;
  internal::unit_setting() = unit;
  return true;
}

template <class Real>
internal::Front_kernels<Real> kernels_for(int planes, [[maybe_unused]] internal::Vector_unit unit)
{
#ifdef CGP_HAS_X86_UNITS
  if (unit == internal::Vector_unit::avx512)
    return internal::compiled_kernels(internal::Avx512_unit(), Real(), planes);
  if (unit == internal::Vector_unit::avx2)
    return internal::compiled_kernels(internal::Avx2_unit(), Real(), planes);
#endif
  return unit_kernels<internal::Library_unit, Real>(planes);
}

template internal::Front_kernels<double> kernels_for<double>(int, internal::Vector_unit);
template internal::Front_kernels<float> kernels_for<float>(int, internal::Vector_unit);

}  // namespace Conformal_geometry_processing
