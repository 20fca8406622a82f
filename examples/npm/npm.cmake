# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# The npm package `conformal-geometry` in the build folder: the target npm, of the kernels that the studio
# has. `npm pack` there makes the archive.

set(CGP_NPM_PACKAGE ${CMAKE_CURRENT_BINARY_DIR}/npm)
file(GLOB npm_parts CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/index.* ${CMAKE_CURRENT_LIST_DIR}/README.md
     ${CMAKE_CURRENT_LIST_DIR}/example/*)
configure_file(${CMAKE_CURRENT_LIST_DIR}/package.json.in ${CGP_NPM_PACKAGE}/package.json @ONLY)
set(npm_surface ${CMAKE_CURRENT_SOURCE_DIR}/conformal/studio/page/surface.js)
add_custom_command(OUTPUT ${CGP_NPM_PACKAGE}/kernels.js
                   COMMAND ${CMAKE_COMMAND} -D PARTS=${CMAKE_CURRENT_LIST_DIR} -D PACKAGE=${CGP_NPM_PACKAGE}
                           -D KERNELS=${kernels} -D SURFACE=${npm_surface}
                           -D LICENSE=${PROJECT_SOURCE_DIR}/doc/licenses/LGPL-3.0-or-later.txt
                           -P ${CMAKE_CURRENT_LIST_DIR}/join.cmake
                   DEPENDS ${kernels} ${npm_surface} ${npm_parts} ${CMAKE_CURRENT_LIST_DIR}/join.cmake VERBATIM)
add_custom_target(npm ALL DEPENDS ${CGP_NPM_PACKAGE}/kernels.js)
