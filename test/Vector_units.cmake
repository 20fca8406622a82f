# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# What the linker must not mix: code compiled for different vector units in one program.

if(NOT CGP_HAS_X86_UNITS)
  return()
endif()

# Two files for different units over the compiled library give the same bits. Used header-only, they
# give right results.
find_package(Python3 QUIET COMPONENTS Interpreter)
set(libraries linear_algebra)
if(Python3_FOUND)
  add_custom_target(header_only ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/tools/header_only.py
                                ${CMAKE_CURRENT_BINARY_DIR}/header_only VERBATIM)
  add_library(cgp_header_only INTERFACE)
  add_dependencies(cgp_header_only header_only)
  target_include_directories(cgp_header_only INTERFACE ${CMAKE_CURRENT_BINARY_DIR}/header_only)
  target_compile_definitions(cgp_header_only INTERFACE CGP_HEADER_ONLY)
  target_link_libraries(cgp_header_only INTERFACE Eigen3::Eigen Threads::Threads)
  list(APPEND libraries header_only)
endif()
foreach(library IN LISTS libraries)
  foreach(unit baseline avx2)
    set(part two_targets.${library}.${unit})
    add_library(${part} OBJECT tools/two_targets.cpp)
    target_include_directories(${part} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
    target_compile_definitions(${part} PRIVATE CGP_UNIT=${unit} EIGEN_MAX_ALIGN_BYTES=16
                                               EIGEN_MALLOC_ALREADY_ALIGNED=0)
    target_link_libraries(${part} PRIVATE cgp_${library})
  endforeach()
  target_compile_options(two_targets.${library}.avx2 PRIVATE -mavx2 -mfma)
  target_compile_definitions(two_targets.${library}.baseline PRIVATE CGP_MAIN)
  target_sources(two_targets.${library}.baseline PRIVATE quaternionic_linear_algebra/hermitian_matrices.cpp)
  add_executable(two_targets.${library} $<TARGET_OBJECTS:two_targets.${library}.baseline>
                                        $<TARGET_OBJECTS:two_targets.${library}.avx2>)
  target_link_libraries(two_targets.${library} PRIVATE cgp_${library})
  add_test(NAME two_targets.${library} COMMAND two_targets.${library})
endforeach()

# No file of the library defines what belongs to the unit of another one.
if(Python3_FOUND AND CMAKE_NM)
  add_test(NAME sources.vector_symbols COMMAND_EXPAND_LISTS
           COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/tools/check_vector_symbols.py
                   ${CMAKE_NM} $<TARGET_OBJECTS:cgp_linear_algebra>)
endif()
