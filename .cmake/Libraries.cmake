# Copyright (c) 2026 The Conformal Geometry Processing authors
# SPDX-License-Identifier: LGPL-3.0-or-later
# The targets users link, all in the namespace Conformal_geometry_processing::
#   linear_algebra        compiled; threads/, algebra/, linear_algebra/: needs Eigen only
#   kernels               compiled; the geometry, on flat arrays: needs Eigen only
#   core                  the headers that take CGAL's meshes
#   cholmod metis slepc   the headers over one more library each
# linear_algebra_header_only, kernels_header_only and core_header_only are the same with nothing to
# link: all is compiled in the files that include it.

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

set(CGP_INCLUDE ${PROJECT_SOURCE_DIR}/include/Conformal_geometry_processing)
file(GLOB_RECURSE CGP_HEADERS CONFIGURE_DEPENDS ${CGP_INCLUDE}/*.h)

# The headers whose path below the library's folder matches: cgp_headers(<variable> <regex>).
function(cgp_headers variable regex)
  set(headers ${CGP_HEADERS})
  list(FILTER headers INCLUDE REGEX "^${CGP_INCLUDE}/${regex}")
  set(${variable} ${headers} PARENT_SCOPE)
endfunction()

cgp_headers(CGP_CHOLMOD_HEADERS "linear_algebra/adapters/Cholmod_")
cgp_headers(CGP_METIS_HEADERS "linear_algebra/adapters/Metis_")
cgp_headers(CGP_SLEPC_HEADERS "linear_algebra/adapters/(Petsc|Slepc)_")
cgp_headers(CGP_LINEAR_ALGEBRA_HEADERS "(threads/|algebra/|linear_algebra/|config|exceptions|version)")
list(REMOVE_ITEM CGP_LINEAR_ALGEBRA_HEADERS ${CGP_CHOLMOD_HEADERS} ${CGP_METIS_HEADERS}
     ${CGP_SLEPC_HEADERS})
cgp_headers(CGP_KERNELS_HEADERS
            "((mesh|operators|conformal_class|forms|measure|painting|spin|flow|parameterization|surfaces|curves)/|templates)")
cgp_headers(CGP_CORE_HEADERS "(core/|[^/]*$)")
list(REMOVE_ITEM CGP_CORE_HEADERS ${CGP_LINEAR_ALGEBRA_HEADERS} ${CGP_KERNELS_HEADERS})

# A program with some commands only needs a part of its own sources and of the compiled libraries:
# all is compiled that cgp_keep_what_is_needed(<variable>) leaves in a list of sources.
set(CGP_NEEDED "")
include(${PROJECT_SOURCE_DIR}/examples/conformal/commands/commands.cmake)
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
  file(GLOB_RECURSE sources ${program}/*.cpp ${CGP_INCLUDE}/*instances_impl.h)
  list(FILTER sources EXCLUDE REGEX "/(commands/[a-z]+|wasm/.*)\\.cpp$")
  cgp_reached(CGP_NEEDED "${program}/main.cpp;${commands}" "${sources}" "${CGP_INCLUDE}/templates.h")
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

# What a target has in common with its twin that compiles nothing: cgp_describe(<target> <scope of
# what it compiles with> <its headers>...).
function(cgp_describe target scope)
  string(REGEX REPLACE "^cgp_" "" name ${target})
  add_library(Conformal_geometry_processing::${name} ALIAS ${target})
  set(interfaces ${ARGN})
  set(implementations ${ARGN})
  list(FILTER interfaces EXCLUDE REGEX "_(impl|templates)\\.h$")
  list(FILTER implementations INCLUDE REGEX "_(impl|templates)\\.h$")
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name}
                        VERIFY_INTERFACE_HEADER_SETS ON INTERFACE_HEADER_SETS_TO_VERIFY HEADERS)
  target_sources(${target} ${scope}
    FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/include FILES ${interfaces}
    FILE_SET implementations TYPE HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/include
             FILES ${implementations})
  target_compile_features(${target} ${scope} cxx_std_17)
endfunction()

# Headers alone, over other targets: cgp_add_headers(<name> "<targets>" <header>...)
function(cgp_add_headers name targets)
  add_library(cgp_${name} INTERFACE)
  cgp_describe(cgp_${name} INTERFACE ${ARGN})
  target_link_libraries(cgp_${name} INTERFACE ${targets})
endfunction()

# The files that are compiled, of some *_impl.h each, for what they include costs more than they do
# themselves; each file of instances, which are large, alone.
function(cgp_joined_sources name implementations result)
  set(sources "")
  list(LENGTH implementations left)
  while(left GREATER 0)
    list(GET implementations 0 some)
    if(NOT some MATCHES "instances_impl") # those come first
      list(SUBLIST implementations 0 ${CGP_IMPLEMENTATIONS_TOGETHER} some)
    endif()
    list(REMOVE_ITEM implementations ${some})
    list(LENGTH implementations left)
    list(TRANSFORM some REPLACE "^${PROJECT_SOURCE_DIR}/include/(.*)$" "#include <\\1>\n")
    list(JOIN some "" content)
    list(LENGTH sources number)
    set(source ${PROJECT_BINARY_DIR}/${name}_${number}.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "${content}" @ONLY)
    list(APPEND sources ${source})
  endwhile()
  set(${result} ${sources} PARENT_SCOPE)
endfunction()
set(CGP_IMPLEMENTATIONS_TOGETHER 12 CACHE STRING "how many implementations are compiled as one")

# A library and its header-only twin: cgp_add_compiled(<name> "<targets below>" <header>...)
function(cgp_add_compiled name below)
  add_library(cgp_${name})
  cgp_describe(cgp_${name} PUBLIC ${ARGN})
  set(implementations ${ARGN})
  list(FILTER implementations INCLUDE REGEX "_impl\\.h$")
  cgp_keep_what_is_needed(implementations)
  set(instances ${implementations})
  list(FILTER instances INCLUDE REGEX "instances_impl")
  list(REMOVE_ITEM implementations ${instances})
  list(PREPEND implementations ${instances})
  cgp_joined_sources(${name} "${implementations}" sources)
  target_sources(cgp_${name} PRIVATE ${sources})
  set_target_properties(cgp_${name} PROPERTIES OUTPUT_NAME conformal_geometry_${name}
                        VERSION ${PROJECT_VERSION} POSITION_INDEPENDENT_CODE ON
                        INSTALL_RPATH "$ORIGIN" # where the library below is
                        SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  # Compiled for AVX, Eigen looks for what to free where it has put nothing without AVX, unless both
  # are told that malloc() is not aligned.
  target_compile_definitions(cgp_${name} PUBLIC EIGEN_MAX_ALIGN_BYTES=16
                                                EIGEN_MALLOC_ALREADY_ALIGNED=0)
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

  list(TRANSFORM below APPEND _header_only)
  cgp_add_headers(${name}_header_only "${below};Eigen3::Eigen;Threads::Threads" ${ARGN})
  set_target_properties(cgp_${name}_header_only PROPERTIES VERIFY_INTERFACE_HEADER_SETS OFF)
  target_compile_definitions(cgp_${name}_header_only
                             INTERFACE CONFORMAL_GEOMETRY_PROCESSING_HEADER_ONLY)
endfunction()

include(CheckLinkerFlag)
set(CMAKE_REQUIRED_QUIET ON)
check_linker_flag(CXX "LINKER:--version-script=${PROJECT_SOURCE_DIR}/.cmake/exported_symbols.map"
                  CGP_HAS_VERSION_SCRIPTS)

cgp_add_compiled(linear_algebra "" ${CGP_LINEAR_ALGEBRA_HEADERS})
include(Vector_units)
cgp_add_vector_units(cgp_linear_algebra)
cgp_add_compiled(kernels cgp_linear_algebra ${CGP_KERNELS_HEADERS})
if(CGP_KERNELS_ONLY)
  return()
endif()
set(kernels cgp_kernels)
if(CGP_HEADER_ONLY)
  set(kernels cgp_kernels_header_only)
endif()
cgp_add_headers(core "${kernels};CGAL::CGAL" ${CGP_CORE_HEADERS})
cgp_add_headers(core_header_only "cgp_kernels_header_only;CGAL::CGAL" ${CGP_CORE_HEADERS})
set_target_properties(cgp_core_header_only PROPERTIES VERIFY_INTERFACE_HEADER_SETS OFF)

if(CGP_HAS_CHOLMOD)
  cgp_add_headers(cholmod "cgp_core;CHOLMOD::CHOLMOD" ${CGP_CHOLMOD_HEADERS})
  target_compile_definitions(cgp_cholmod INTERFACE CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD)
endif()
if(CGP_HAS_METIS)
  cgp_add_headers(metis "cgp_core;METIS::METIS" ${CGP_METIS_HEADERS})
endif()
if(CGP_HAS_SLEPC)
  cgp_add_headers(slepc "cgp_core;SLEPc::SLEPc" ${CGP_SLEPC_HEADERS})
endif()
