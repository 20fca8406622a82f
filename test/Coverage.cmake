# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# Which lines of the library the tests run: with CGP_COVERAGE the compiled libraries and the tests
# count, and `cmake --build FOLDER --target coverage` adds up what they have counted.

if(CGP_COVERAGE AND (NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU" OR CGP_SANITIZE))
  message(STATUS "Lines are counted with g++ alone, and not beside sanitizers")
  set(CGP_COVERAGE OFF)
endif()
if(CGP_COVERAGE)
  string(REGEX MATCH "^[0-9]+" major "${CMAKE_CXX_COMPILER_VERSION}")
  find_program(CGP_GCOV NAMES gcov-${major} gcov REQUIRED)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  set(CGP_COVERAGE_AT_LEAST 95 CACHE STRING "per cent of the lines the tests must run")
  mark_as_advanced(CGP_GCOV CGP_COVERAGE_AT_LEAST)
  add_custom_target(
    coverage COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/tools/coverage.py
                     --gcov ${CGP_GCOV} --at-least ${CGP_COVERAGE_AT_LEAST} --missing
                     ${PROJECT_BINARY_DIR}
    USES_TERMINAL VERBATIM)
endif()

# Has a target (PRIVATE), or those that link it (INTERFACE), count the lines of the library that they
# run, also where those were inlined. Threads may lose a count: all that is asked is whether it is
# zero. The pattern stands for /Conf|/Quat|/test: g++ matches it for each function of all headers, and the
# alternative took it as long as all else together.
function(cgp_count_lines target scope)
  if(CGP_COVERAGE)
    target_compile_options(${target} ${scope} --coverage -fprofile-update=single
                           "-fprofile-filter-files=/[CQt][oue][nas][ft]")
    target_link_options(${target} ${scope} --coverage)
  endif()
endfunction()

foreach(library linear_algebra kernels)
  cgp_count_lines(cgp_${library} PRIVATE)
endforeach()
