# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# Joins the sources of the page and three.js into C++ that holds the page as two strings, what comes
# before the data and what comes after.
#
# usage: cmake -D OUTPUT=FILE.cpp [-D THREE=FILE -D LICENSE=FILE | -D FAULT=WORDS -D ADVICE=WORDS] -P join.cmake

include(${CMAKE_CURRENT_LIST_DIR}/page_text.cmake)
set(page "")
if(THREE)
  set(here ${CMAKE_CURRENT_LIST_DIR})
  file(READ ${here}/page.html page)
  file(READ ${here}/style.css style)
  file(READ ${THREE} three)
  file(READ ${LICENSE} license)
  set(code "")
  foreach(part geometry colours data charts tables tiles controls checkerboard shaders viewer main)
    file(READ ${here}/${part}.js source)
    string(APPEND code "${source}")
  endforeach()
  hash_of("\n${code}\n" code_hash)
  hash_of("\n${style}\n" style_hash)
  # Scripts: that of the page, and three.js, which it makes of its block.
  set(policy "default-src 'none'; script-src ${code_hash} blob:; style-src ${style_hash}; img-src data:; \
base-uri 'none'; form-action 'none'")
  foreach(part policy style license three code)
    fill_in(${part})
  endforeach()
endif()
write_page(${OUTPUT} conformal/report/report_page.h report_page "${FAULT}" "${ADVICE}")
