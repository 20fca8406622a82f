# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# What is built and with which checks. A project that adds this one as a subdirectory gets the
# libraries alone: everything below is off there.

option(CGP_BUILD_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(CGP_BUILD_EXAMPLES "Build the examples and the program conformal" ${PROJECT_IS_TOP_LEVEL})
option(CGP_BUILD_PYTHON "Build the Python module" ${CGP_BUILD_EXAMPLES})
option(CGP_BUILD_BENCHMARKS "Build the benchmarks" ${PROJECT_IS_TOP_LEVEL})
option(CGP_BUILD_DOC "Check and build the reference manual" ${PROJECT_IS_TOP_LEVEL})
option(CGP_HTML_REPORT "HTML reports of the program; npm fetches three.js" ${PROJECT_IS_TOP_LEVEL})
option(CGP_STUDIO "The page of `conformal studio`; emscripten compiles the kernels" ${PROJECT_IS_TOP_LEVEL})
set(CGP_COMMANDS all CACHE STRING "the commands of the program that are built, for instance spin;info, \
with what they need of the libraries; or all")
option(CGP_WARNINGS_AS_ERRORS "Stop at a warning in our own code, as test/run does" OFF)
option(CGP_KERNELS_ONLY "Build what needs no CGAL: the compiled libraries, the Python module" OFF)
option(CGP_NATIVE "Compile for this very machine (-march=native)" OFF)
option(CGP_COVERAGE "Count which lines of the library the tests run (g++)" OFF)
set(CGP_SANITIZE "" CACHE STRING "address (with undefined behaviour), fuzzer, thread, or nothing")
set_property(CACHE CGP_SANITIZE PROPERTY STRINGS "" address fuzzer thread)

if(PROJECT_IS_TOP_LEVEL)
  option(BUILD_SHARED_LIBS "Build the libraries shared; a static one takes over the vector units \
of the program that links it, where they share a template" ON)
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    # The numerics are unusable without optimization, and CGAL warns otherwise.
    set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, Debug or RelWithDebInfo" FORCE)
  endif()
  set(CMAKE_CXX_EXTENSIONS OFF)

  # CGAL, Eigen and the others come in through imported targets, that is with -isystem.
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    add_compile_options(-Wall -Wextra -Wshadow -Wconversion)
    if(CGP_WARNINGS_AS_ERRORS)
      add_compile_options(-Werror)
      if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        # A guess of the optimizer that is often wrong, and blames us for OpenMesh and Eigen.
        add_compile_options(-Wno-error=maybe-uninitialized -Wno-error=array-bounds)
      endif()
    endif()
  endif()
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    # CGAL asks for -frounding-math, which some versions of clang do not know.
    add_compile_options(-Wno-unknown-warning-option -Wno-ignored-optimization-argument
                        -Wno-unused-command-line-argument)
  endif()
  if(CGP_NATIVE)
    add_compile_options(-march=native)
  endif()

  if(CGP_SANITIZE STREQUAL "address")
    set(sanitizers -fsanitize=address,undefined -fno-sanitize-recover=undefined)
  elseif(CGP_SANITIZE STREQUAL "fuzzer") # address, and what libFuzzer wants to see
    set(sanitizers -fsanitize=address,undefined,fuzzer-no-link -fno-sanitize-recover=undefined)
  elseif(CGP_SANITIZE STREQUAL "thread")
    set(sanitizers -fsanitize=thread)
  elseif(CGP_SANITIZE)
    message(FATAL_ERROR "CGP_SANITIZE is \"${CGP_SANITIZE}\"; it can be address, fuzzer, thread, "
                        "or empty")
  endif()
  if(sanitizers)
    add_compile_options(${sanitizers} -fno-omit-frame-pointer -g1)
    add_compile_definitions(_GLIBCXX_ASSERTIONS) # what is read behind a vector's end may be its own
    add_link_options(${sanitizers})
  endif()
endif()

# find_package that says which Debian package is wanted: cgp_find(<variable> <Debian package>
# <arguments of find_package>) sets <variable>.
macro(cgp_find variable debian_package package)
  find_package(${package} ${ARGN})
  set(${variable} ${${package}_FOUND})
  if(NOT ${variable})
    message(STATUS "Without ${package}; to have it, on Debian: apt-get install ${debian_package}")
  endif()
endmacro()
