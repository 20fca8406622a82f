# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# Damaged files for the readers and the program (doc/fuzzing.md). A few of them are tests; by the
# thousand they are wanted with sanitizers, and then by hand: test/tools/fuzz.

function(cgp_add_fuzz_program name library)
  add_executable(${name} ${ARGN} tools/${name}.cpp)
  target_link_libraries(${name} PRIVATE ${library} cgp_test_support)
endfunction()

foreach(what readers runs)
  set(library conformal_io)
  set(table "")
  if(what STREQUAL "runs")
    set(library conformal_commands)
    set(table ${PROJECT_BINARY_DIR}/examples/commands.cpp)
  endif()
  if(NOT TARGET ${library})
    continue()
  endif()
  cgp_add_fuzz_program(fuzz_${what} ${library} ${table})
  add_test(NAME program.fuzz_${what} COMMAND fuzz_${what} 100)
  if(CGP_SANITIZE STREQUAL "fuzzer")
    cgp_add_fuzz_program(fuzz_${what}_guided ${library} EXCLUDE_FROM_ALL ${table})
    target_link_options(fuzz_${what}_guided PRIVATE -fsanitize=fuzzer)
  endif()
endforeach()
