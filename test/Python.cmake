# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# The Python module: test/python/test_*.py by pytest, with the module of the build folder. A Python
# that was not built with a sanitizer cannot load a module that was.

if(NOT TARGET conformal_geometry OR CGP_SANITIZE)
  return()
endif()
execute_process(COMMAND ${CGP_PYTHON} -c "import pytest" RESULT_VARIABLE no_pytest ERROR_QUIET)
if(NOT no_pytest EQUAL 0)
  message(STATUS "No tests of the Python module; on Debian: apt-get install python3-pytest")
  return()
endif()

set(environment "PYTHONPATH=${PROJECT_BINARY_DIR}/examples/python" PYTHONDONTWRITEBYTECODE=1
                "CGP_BUILD_FOLDER=${PROJECT_BINARY_DIR}")
if(TARGET conformal)
  list(APPEND environment "CGP_CONFORMAL_PROGRAM=$<TARGET_FILE:conformal>")
endif()
add_test(NAME python.module COMMAND ${CGP_PYTHON} -m pytest -q -p no:cacheprovider
         ${CMAKE_CURRENT_SOURCE_DIR}/python)
set_tests_properties(python.module PROPERTIES TIMEOUT 600 ENVIRONMENT "${environment}")
