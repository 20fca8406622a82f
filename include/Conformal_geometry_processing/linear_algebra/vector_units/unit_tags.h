// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

namespace Conformal_geometry_processing::internal {

/// \ingroup PkgLinearAlgebra
/// \brief The vector units for which the dense kernels of the factorizations are compiled,
/// narrowest first.
enum class Vector_unit {
  baseline,  ///< 16 bytes, available on every machine of the target: SSE2, NEON
  avx2,      ///< 32 bytes: AVX2 and FMA
  avx512     ///< 64 bytes: AVX-512 F, VL, DQ and BW
};

/// \ingroup PkgLinearAlgebra
/// \name Vector units
/// Tag types of the vector units. All code that depends on the width of a register has one as a
/// template parameter, so that instances for different units have different names.
/// @{

/// 16 bytes
struct Baseline_unit {
  static constexpr Vector_unit unit = Vector_unit::baseline;
  static constexpr int bytes = 16;      ///< in a register
  static constexpr int registers = 16;  ///< available to a kernel
};

/// 32 bytes
struct Avx2_unit {
  static constexpr Vector_unit unit = Vector_unit::avx2;
  static constexpr int bytes = 32;
  static constexpr int registers = 16;
};

/// 64 bytes
struct Avx512_unit {
  static constexpr Vector_unit unit = Vector_unit::avx512;
  static constexpr int bytes = 64;
  static constexpr int registers = 32;
};

/// The widest unit for which this file is compiled: a wider kernel would spill to memory and be
/// several times slower than a narrow one
#if defined(__AVX512F__)
using Target_unit = Avx512_unit;
#elif defined(__AVX2__)
using Target_unit = Avx2_unit;
#else
using Target_unit = Baseline_unit;
#endif
/// @}

}  // namespace Conformal_geometry_processing::internal
