# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# Joins the sources of the studio, the viewer of the reports, three.js and the kernels into C++ that
# holds the page.
#
# usage: cmake -D OUTPUT=FILE.cpp -D PREFIX=FOLDER
#              [-D THREE=FILE -D LICENSE=FILE -D KERNELS=FILE | -D FAULT=WORDS -D ADVICE=WORDS] -P join.cmake

set(here ${CMAKE_CURRENT_LIST_DIR})
set(reports ${here}/../../report/html)
include(${reports}/page_text.cmake)

set(page "")
if(THREE)
  file(READ ${here}/page.html page)
  file(READ ${reports}/style.css style)
  file(READ ${here}/studio.css own)
  string(APPEND style "${own}")
  file(READ ${THREE} three)
  file(READ ${LICENSE} license)
  file(READ ${KERNELS} kernels)
  file(READ ${here}/surface.js surface)
  file(READ ${here}/worker.js worker)
  string(PREPEND worker "${surface}")
  set(code "")
  foreach(part ${reports}/geometry ${reports}/colours ${reports}/controls ${reports}/checkerboard
               ${reports}/shaders ${reports}/viewer data kernels history session brush strokes pulls formula
               glb files certificate editor opening main)
    cmake_path(ABSOLUTE_PATH part BASE_DIRECTORY ${here})
    file(READ ${part}.js source)
    string(APPEND code "${source}")
  endforeach()
  hash_of("\n${code}\n" code_hash)
  hash_of("\n${style}\n" style_hash)
  # Scripts: that of the page, and those that it makes of its blocks. The kernels read themselves as data.
  set(policy "default-src 'none'; script-src ${code_hash} blob: 'wasm-unsafe-eval'; worker-src blob:; \
style-src ${style_hash}; img-src data: blob:; connect-src data:; base-uri 'none'; form-action 'none'")
  foreach(part policy style license three kernels worker code)
    fill_in(${part})
  endforeach()
endif()
write_page(${OUTPUT} conformal/studio/studio_page_text.h studio_page "${FAULT}" "${ADVICE}")
file(APPEND ${OUTPUT} "
namespace conformal {
const char* const studio_page_prefix = \"${PREFIX}\";
}
")
