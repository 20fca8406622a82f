# Copyright (c) 2026 The Conformal Geometry Processing authors
# SPDX-License-Identifier: LGPL-3.0-or-later
# Joins the sources of the page and three.js into C++ that holds the page as two strings, what comes
# before the data and what comes after.
#
# usage: cmake -D OUTPUT=FILE.cpp [-D THREE=FILE -D LICENSE=FILE | -D FAULT=WORDS] -P join.cmake

include(${CMAKE_CURRENT_LIST_DIR}/page_text.cmake)
set(page "")
if(THREE)
  set(here ${CMAKE_CURRENT_LIST_DIR})
  file(READ ${here}/page.html page)
  file(READ ${here}/style.css style)
  file(READ ${THREE} three)
  file(READ ${LICENSE} license)
  set(code "")
  foreach(part geometry colours data charts tables controls checkerboard shaders viewer main)
    file(READ ${here}/${part}.js source)
    string(APPEND code "${source}")
  endforeach()
  foreach(part style license three code)
    fill_in(${part})
  endforeach()
endif()
write_page(${OUTPUT} conformal/report/report_page.h report_page "${FAULT}")
