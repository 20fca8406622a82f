# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# Puts the page of `--html` into the target conformal_lib, or, where there is no three.js, the reason and
# what to do.

include(${CMAKE_CURRENT_LIST_DIR}/page_text.cmake)

set(Three_FAULT "it was configured without CGP_HTML_REPORT")
set(CGP_HAS_THREE FALSE)
if(CGP_HTML_REPORT)
  cgp_find(CGP_HAS_THREE npm Three QUIET)
endif()
if(CGP_HAS_THREE)
  set(arguments -D THREE=${Three_MODULE} -D LICENSE=${Three_LICENSE})
  set(archive ${Three_MODULE})
else()
  message(STATUS "conformal is built without --html: ${Three_FAULT}")
  cgp_build_advice(-DCGP_HTML_REPORT=ON "about a minute" advice npm)
  set(arguments -D "FAULT=${Three_FAULT}" -D "ADVICE=${advice}")
  set(archive "")
endif()
set(report_page ${CMAKE_CURRENT_BINARY_DIR}/report_page.cpp)
file(GLOB page_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*)
add_custom_command(OUTPUT ${report_page}
                   COMMAND ${CMAKE_COMMAND} -D OUTPUT=${report_page} ${arguments}
                           -P ${CMAKE_CURRENT_LIST_DIR}/join.cmake
                   DEPENDS ${page_sources} ${archive} VERBATIM)
target_sources(conformal_lib PRIVATE ${report_page})
