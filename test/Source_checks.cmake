# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# Checks of the sources themselves: layers, licences, lengths, ... one ctest each, `sources.<what>`.

find_package(Python3 QUIET COMPONENTS Interpreter)
if(NOT Python3_FOUND)
  message(STATUS "No checks of the sources without python3; on Debian: apt-get install python3")
else()
  set(licences_arguments ${CMAKE_CXX_COMPILER} -DEIGEN_MALLOC_ALREADY_ALIGNED=0)
  foreach(folder IN LISTS EIGEN3_INCLUDE_DIRS CGAL_INCLUDE_DIRS)
    if(NOT folder STREQUAL "/usr/include") # -isystem /usr/include breaks #include_next
      list(APPEND licences_arguments -isystem ${folder})
    endif()
  endforeach()
  # These read all headers in one translation unit, which takes g++ four times as long.
  find_program(CGP_CLANG NAMES clang++ clang++-14)
  mark_as_advanced(CGP_CLANG)
  set(all_at_once_arguments ${licences_arguments})
  if(CGP_CLANG)
    list(REMOVE_AT all_at_once_arguments 0)
    list(PREPEND all_at_once_arguments ${CGP_CLANG})
  endif()
  set(headers_alone_arguments ${licences_arguments})
  set(hostile_macros_arguments ${all_at_once_arguments})
  set(two_units_arguments ${all_at_once_arguments})
  if(TARGET conformal)
    set(subcommands_arguments $<TARGET_FILE:conformal>)
  endif()
  list(GET all_at_once_arguments 0 cgal_package_arguments) # header-only, a third of g++'s time
  foreach(what headers_alone hostile_macros two_units layers licences mirrored_tests format lengths
               heads includes performance thesis_map manual manual_tasks public_types
               reference developers subcommands cgal_package)
    add_test(NAME sources.${what} COMMAND ${Python3_EXECUTABLE}
             ${CMAKE_CURRENT_SOURCE_DIR}/tools/check_${what}.py ${${what}_arguments})
  endforeach()

  add_test(NAME sources.partial_builds COMMAND ${Python3_EXECUTABLE}
           ${CMAKE_CURRENT_SOURCE_DIR}/tools/check_partial_builds.py ${CMAKE_GENERATOR})

  # Every example succeeds on a generated surface.
  file(GLOB examples CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/examples/*.cpp)
  foreach(example IN LISTS examples)
    cmake_path(GET example STEM name)
    set(arguments ${PROJECT_BINARY_DIR}/examples/${name})
    if(name STREQUAL "first_program" AND TARGET conformal)
      list(APPEND arguments $<TARGET_FILE:conformal>)
    endif()
    add_test(NAME examples.${name} COMMAND ${Python3_EXECUTABLE}
             ${CMAKE_CURRENT_SOURCE_DIR}/tools/check_example.py ${arguments})
  endforeach()
endif()

# The pages of `conformal --html` and `conformal studio` in a browser.
find_program(CGP_CHROMIUM NAMES chromium chromium-browser google-chrome)
mark_as_advanced(CGP_CHROMIUM)
if(NOT CGP_CHROMIUM)
  message(STATUS "No test of HTML reports without a browser; on Debian: apt-get install chromium")
elseif(Python3_FOUND AND TARGET conformal AND CGP_HAS_THREE)
  add_test(NAME program.html_report_in_chromium COMMAND ${Python3_EXECUTABLE}
           ${CMAKE_CURRENT_SOURCE_DIR}/tools/check_html_report.py $<TARGET_FILE:conformal>
           ${CGP_CHROMIUM})
  set_tests_properties(program.html_report_in_chromium PROPERTIES TIMEOUT 600)
  if(CGP_HAS_STUDIO)
    add_test(NAME program.studio_in_chromium COMMAND ${Python3_EXECUTABLE}
             ${CMAKE_CURRENT_SOURCE_DIR}/tools/check_studio.py $<TARGET_FILE:conformal>
             ${CGP_CHROMIUM})
    set_tests_properties(program.studio_in_chromium PROPERTIES TIMEOUT 1200)
  endif()
endif()

# The npm package, installed from its archive.
find_program(CGP_NODE NAMES node nodejs)
mark_as_advanced(CGP_NODE)
if(CGP_NPM_PACKAGE AND CGP_NODE AND NPM_EXECUTABLE AND Python3_FOUND)
  set(npm_arguments ${CGP_NPM_PACKAGE} ${CGP_NODE} ${NPM_EXECUTABLE})
  if(CGP_CHROMIUM)
    list(APPEND npm_arguments ${Three_MODULE} ${CGP_CHROMIUM})
  endif()
  add_test(NAME npm.package COMMAND ${Python3_EXECUTABLE}
           ${CMAKE_CURRENT_SOURCE_DIR}/tools/check_npm_package.py ${npm_arguments})
  set_tests_properties(npm.package PROPERTIES TIMEOUT 600)
endif()

# test/compile_fail/*.cpp must not compile, and the message must match the first line's
# `// expect: <regular expression>`.
file(GLOB failing CONFIGURE_DEPENDS compile_fail/*.cpp)
foreach(source IN LISTS failing)
  cmake_path(GET source STEM name)
  file(STRINGS ${source} expectation REGEX "^// expect: " LIMIT_COUNT 1)
  string(REPLACE "// expect: " "" expectation "${expectation}")
  if(expectation STREQUAL "")
    message(FATAL_ERROR "${source} has no line \"// expect: <regular expression>\"")
  endif()
  add_library(compile_fail.${name} OBJECT EXCLUDE_FROM_ALL ${source})
  target_link_libraries(compile_fail.${name} PRIVATE cgp_core)
  target_include_directories(compile_fail.${name} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  add_test(NAME compile_fail.${name} COMMAND ${CMAKE_COMMAND} --build ${PROJECT_BINARY_DIR}
           --target compile_fail.${name})
  set_tests_properties(compile_fail.${name} PROPERTIES RESOURCE_LOCK build_tree
                       PASS_REGULAR_EXPRESSION "${expectation}")
endforeach()

# Projects that use the library as its users do: found after installation, from Debian packages, and
# as a subdirectory.
set(ways installed subdirectory)
if(CPACK_DEB_COMPONENT_INSTALL AND TARGET conformal AND EXISTS /usr/bin/dpkg-shlibdeps)
  list(APPEND ways packages)
else()
  message(STATUS "No test of Debian packages; on Debian: apt-get install dpkg-dev")
endif()
foreach(way IN LISTS ways)
  set(compiler ${CMAKE_CXX_COMPILER})
  if(way STREQUAL "subdirectory" AND CGP_CLANG)
    set(compiler ${CGP_CLANG})
  endif()
  add_test(NAME downstream.${way} COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/tools/check_downstream.sh
           ${way} ${PROJECT_BINARY_DIR} ${compiler} ${CMAKE_GENERATOR})
  # To make packages is to ask whether all is built.
  set_tests_properties(downstream.${way} PROPERTIES TIMEOUT 600 RESOURCE_LOCK build_tree)
endforeach()
