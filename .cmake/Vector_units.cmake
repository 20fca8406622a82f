# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# The dense kernels of linear_algebra once more for each vector unit of the architecture that not
# every machine has. The library chooses among them when a program runs; without this, or with
# another compiler, it has those of every machine alone.

set(CGP_FLAGS_OF_Avx2_unit -mavx2 -mfma)
set(CGP_FLAGS_OF_Avx512_unit -mavx2 -mfma -mavx512f -mavx512vl -mavx512dq -mavx512bw)

# A Mac's compiler makes one file for several architectures, of which not all know the flags.
include(CheckCXXSourceCompiles)
set(CMAKE_REQUIRED_FLAGS "${CGP_FLAGS_OF_Avx512_unit}")
list(JOIN CMAKE_REQUIRED_FLAGS " " CMAKE_REQUIRED_FLAGS)
check_cxx_source_compiles("
#if !defined(__x86_64__) && !defined(__i386__)
#error other units than these
#endif
int main() { return __builtin_cpu_supports(\"avx512vl\") ? 0 : 1; }" CGP_HAS_X86_UNITS)
unset(CMAKE_REQUIRED_FLAGS)

# cgp_add_vector_units(<target>): one source for each unit, with the flags of the unit, which must
# include nothing else: what it shares with other files would be compiled for its unit as well.
function(cgp_add_vector_units target)
  if(NOT CGP_HAS_X86_UNITS)
    return()
  endif()
  foreach(unit Avx2_unit Avx512_unit)
    set(source ${PROJECT_BINARY_DIR}/${unit}.cpp)
    file(CONFIGURE OUTPUT ${source} @ONLY CONTENT "#define CGP_VECTOR_UNIT ${unit}
#include <Quaternionic_linear_algebra/vector_units/compiled_kernels.cpp>
")
    set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS "${CGP_FLAGS_OF_${unit}}"
                                SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
    target_sources(${target} PRIVATE ${source})
  endforeach()
  target_compile_definitions(${target} PRIVATE CGP_HAS_X86_UNITS)
endfunction()
