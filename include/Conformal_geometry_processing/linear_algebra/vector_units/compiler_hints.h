// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

// Compiler-specific hints for the dense kernels. This file, and all that a kernel includes, must
// not define functions that could be called from a file compiled for another vector unit: the
// linker keeps an arbitrary one of several functions with the same name.

#if defined(__GNUC__) && !defined(CONFORMAL_GEOMETRY_PROCESSING_NO_VECTOR_EXTENSIONS)
#define CGP_HAS_VECTOR_EXTENSIONS  // vector types
#endif

#define CGP_PRAGMA(text) _Pragma(#text)

#if defined(__clang__)
#define CGP_ALWAYS_INLINE inline __attribute__((always_inline))
#define CGP_UNROLL(count) CGP_PRAGMA(unroll)
#define CGP_PREFETCH(address) __builtin_prefetch(address)
#elif defined(__GNUC__)
#define CGP_ALWAYS_INLINE inline __attribute__((always_inline))
#define CGP_UNROLL(count) CGP_PRAGMA(GCC unroll count)
#define CGP_PREFETCH(address) __builtin_prefetch(address)
#else
#ifdef _MSC_VER
#define CGP_ALWAYS_INLINE __forceinline
#else
#define CGP_ALWAYS_INLINE inline
#endif
#define CGP_UNROLL(count)
#define CGP_PREFETCH(address) static_cast<void>(address)
#endif
