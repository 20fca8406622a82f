# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# The targets users link, all in the namespace Conformal_geometry_processing::
#   linear_algebra        compiled; include/Quaternionic_linear_algebra: needs Eigen only
#   kernels               compiled; the geometry, on flat arrays: needs Eigen only
#   core                  the headers that take CGAL's meshes
#   cholmod metis slepc   the headers over one more library each

if(NOT CGP_KERNELS_ONLY)
  cgp_find(CGP_HAS_CGAL libcgal-dev CGAL 5.5 QUIET)
endif()
# NO_MODULE: CGAL puts a FindEigen3.cmake of its own on the module path. No version: Eigen 5 says
# that it is not compatible with 3.4, and is.
cgp_find(CGP_HAS_EIGEN libeigen3-dev Eigen3 QUIET NO_MODULE)
find_package(Threads REQUIRED)
cgp_find(CGP_HAS_CHOLMOD libsuitesparse-dev CHOLMOD QUIET MODULE)
cgp_find(CGP_HAS_METIS libmetis-dev METIS QUIET MODULE)
cgp_find(CGP_HAS_SLEPC libslepc-complex-dev SLEPc QUIET MODULE)
if(NOT (CGP_HAS_CGAL OR CGP_KERNELS_ONLY) OR NOT CGP_HAS_EIGEN OR Eigen3_VERSION VERSION_LESS 3.4)
  message(FATAL_ERROR "Conformal Geometry Processing needs CGAL 5.5 or later and Eigen 3.4 or later;"
                      " on Debian: apt-get install libcgal-dev libeigen3-dev")
endif()

set(CGP_INCLUDE ${PROJECT_SOURCE_DIR}/include)
file(GLOB_RECURSE CGP_FILES CONFIGURE_DEPENDS ${CGP_INCLUDE}/*.h ${CGP_INCLUDE}/*.cpp)

# The headers and sources whose path below include/ matches: cgp_files(<variable> <regex>).
function(cgp_files variable regex)
  set(files ${CGP_FILES})
  list(FILTER files INCLUDE REGEX "^${CGP_INCLUDE}/${regex}")
  set(${variable} ${files} PARENT_SCOPE)
endfunction()

cgp_files(CGP_CHOLMOD_FILES "Quaternionic_linear_algebra/adapters/Cholmod_")
cgp_files(CGP_METIS_FILES "Quaternionic_linear_algebra/adapters/Metis_")
cgp_files(CGP_SLEPC_FILES "Quaternionic_linear_algebra/adapters/(Petsc|Slepc)_")
cgp_files(CGP_LINEAR_ALGEBRA_FILES "(Quaternionic_linear_algebra/|Conformal_geometry_processing/version)")
list(REMOVE_ITEM CGP_LINEAR_ALGEBRA_FILES ${CGP_CHOLMOD_FILES} ${CGP_METIS_FILES} ${CGP_SLEPC_FILES})
cgp_files(CGP_KERNELS_FILES
          "Conformal_geometry_processing/(mesh|operators|conformal_class|forms|measure|painting|spin|flow|parameterization|surfaces|curves)/")
cgp_files(CGP_CORE_FILES "Conformal_geometry_processing/(core/|[^/]*$)")
list(REMOVE_ITEM CGP_CORE_FILES ${CGP_LINEAR_ALGEBRA_FILES})

# A program with some commands only needs a part of its own sources and of the compiled libraries:
# all is compiled that cgp_keep_what_is_needed(<variable>) leaves in a list of sources.
set(CGP_NEEDED "")
include(${PROJECT_SOURCE_DIR}/examples/conformal/commands/commands.cmake
        OPTIONAL) # packages of the libraries are built without the program's sources
if(NOT CGP_COMMANDS STREQUAL "all")
  include(Reached_files)
  set(program ${PROJECT_SOURCE_DIR}/examples/conformal)
  set(commands ${CGP_COMMANDS})
  list(REMOVE_ITEM commands ${CGP_ALL_COMMANDS})
  if(commands OR CGP_COMMANDS STREQUAL "")
    message(FATAL_ERROR "CGP_COMMANDS: there is no command '${commands}'; there are "
                        "${CGP_ALL_COMMANDS}, or all")
  endif()
  set(commands ${CGP_COMMANDS})
  list(TRANSFORM commands REPLACE "(.+)" "${program}/commands/\\1.cpp")
  file(GLOB_RECURSE sources ${program}/*.cpp ${CGP_INCLUDE}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/(commands/[a-z]+|wasm/.*)\\.cpp$")
  cgp_reached(CGP_NEEDED "${program}/main.cpp;${commands}" "${sources}")
endif()
function(cgp_keep_what_is_needed variable)
  if(CGP_NEEDED)
    set(kept "")
    foreach(source IN LISTS ${variable})
      if(source IN_LIST CGP_NEEDED)
        list(APPEND kept ${source})
      endif()
    endforeach()
    set(${variable} ${kept} PARENT_SCOPE)
  endif()
endfunction()

# What the targets have in common: cgp_describe(<target> <scope of what it compiles with> <its files>...).
function(cgp_describe target scope)
  string(REGEX REPLACE "^cgp_" "" name ${target})
  add_library(Conformal_geometry_processing::${name} ALIAS ${target})
  set(headers ${ARGN})
  list(FILTER headers INCLUDE REGEX "\\.h$")
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} VERIFY_INTERFACE_HEADER_SETS ON)
  target_sources(${target} ${scope}
    FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/include FILES ${headers})
  target_compile_features(${target} ${scope} cxx_std_17)
endfunction()

# Headers alone, over other targets: cgp_add_headers(<name> "<targets>" <header>...)
function(cgp_add_headers name targets)
  add_library(cgp_${name} INTERFACE)
  cgp_describe(cgp_${name} INTERFACE ${ARGN})
  target_link_libraries(cgp_${name} INTERFACE ${targets})
endfunction()

# A library: cgp_add_compiled(<name> "<targets below>" <file>...)
function(cgp_add_compiled name below)
  set(sources ${ARGN})
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  cgp_keep_what_is_needed(sources)
  add_library(cgp_${name} ${sources})
  cgp_describe(cgp_${name} PUBLIC ${ARGN})
  # Some files are one unit, for what they include costs more than they do themselves.
  set_target_properties(cgp_${name} PROPERTIES OUTPUT_NAME conformal_geometry_${name}
                        UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${CGP_LIBRARY_FILES_TOGETHER}
                        VERSION ${PROJECT_VERSION} POSITION_INDEPENDENT_CODE ON
                        INSTALL_RPATH "$ORIGIN" # where the library below is
                        SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  # Compiled for AVX, Eigen looks for what to free where it has put nothing without AVX, unless both
  # are told that malloc() is not aligned.
  target_compile_definitions(cgp_${name} PUBLIC EIGEN_MAX_ALIGN_BYTES=16
                                                EIGEN_MALLOC_ALREADY_ALIGNED=0)
  # Threads may have stacks of 128 KiB, the size of one temporary of Eigen by default. Where it is
  # compiled for AVX-512, blocks of its products take 18 KiB.
  target_compile_definitions(
    cgp_${name} PRIVATE EIGEN_STACK_ALLOCATION_LIMIT=$<IF:$<BOOL:${CGP_NATIVE}>,20480,16384>)
  if(CGP_NEEDED AND below AND CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    # Such a build is for a first look. The solvers, below, take most of the time of a run.
    target_compile_options(cgp_${name} PRIVATE "$<$<CONFIG:Release>:-O1>")
  endif()
  target_link_libraries(cgp_${name} PUBLIC ${below} Eigen3::Eigen Threads::Threads)
  if(CGP_HAS_VERSION_SCRIPTS)
    # A program may have been compiled for other vector units. Its copies of inline functions and
    # templates, Eigen's and ours, must not replace those of the library.
    target_link_options(cgp_${name} PRIVATE LINKER:-Bsymbolic-functions
                        LINKER:--version-script=${PROJECT_SOURCE_DIR}/.cmake/exported_symbols.map)
  endif()
endfunction()
set(together 12)
if(CGP_NEEDED) # once, without changes to follow
  set(together 40)
endif()
set(CGP_LIBRARY_FILES_TOGETHER ${together} CACHE STRING "how many files of the libraries are compiled as one")

include(CheckLinkerFlag)
set(CMAKE_REQUIRED_QUIET ON)
check_linker_flag(CXX "LINKER:--version-script=${PROJECT_SOURCE_DIR}/.cmake/exported_symbols.map"
                  CGP_HAS_VERSION_SCRIPTS)

cgp_add_compiled(linear_algebra "" ${CGP_LINEAR_ALGEBRA_FILES})
include(Vector_units)
cgp_add_vector_units(cgp_linear_algebra)
cgp_add_compiled(kernels cgp_linear_algebra ${CGP_KERNELS_FILES})
if(CGP_KERNELS_ONLY)
  return()
endif()
cgp_add_headers(core "cgp_kernels;CGAL::CGAL" ${CGP_CORE_FILES})

if(CGP_HAS_CHOLMOD)
  cgp_add_headers(cholmod "cgp_core;CHOLMOD::CHOLMOD" ${CGP_CHOLMOD_FILES})
  target_compile_definitions(cgp_cholmod INTERFACE CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD)
endif()
if(CGP_HAS_METIS)
  cgp_add_headers(metis "cgp_core;METIS::METIS" ${CGP_METIS_FILES})
endif()
# Installed in any case, as find_package looks for SLEPc when the headers are used.
cgp_add_headers(slepc "cgp_core;SLEPc::SLEPc" ${CGP_SLEPC_FILES})
if(NOT CGP_HAS_SLEPC)
  set_target_properties(cgp_slepc PROPERTIES VERIFY_INTERFACE_HEADER_SETS OFF)
endif()
