# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# three.js of the HTML reports, fetched once by npm into the build folder (nothing of it is among
# our sources). Without a network, put the archive that `npm pack` makes there yourself.
#
# Three_FOUND, and then Three_MODULE (the library in one file) and Three_LICENSE (its licence).

set(Three_VERSION 0.170.0) # the last one whose minified library is one file
set(three_sha256 4a608a355dcaba72e0e5383cdc814303f5b6060b43c238cdf6932dceb699238d)
set(three_folder ${PROJECT_BINARY_DIR}/three)
set(three_archive ${three_folder}/three-${Three_VERSION}.tgz)
set(Three_MODULE ${three_folder}/package/build/three.module.min.js)
set(Three_LICENSE ${three_folder}/package/LICENSE)
set(Three_FAULT "")

find_program(NPM_EXECUTABLE npm)
mark_as_advanced(NPM_EXECUTABLE)
if(NOT EXISTS ${three_archive})
  file(MAKE_DIRECTORY ${three_folder})
  if(NPM_EXECUTABLE)
    execute_process(COMMAND ${NPM_EXECUTABLE} pack --loglevel=error --fetch-retries=1 three@${Three_VERSION}
                    WORKING_DIRECTORY ${three_folder} TIMEOUT 120
                    RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE told)
    if(NOT result EQUAL 0 OR NOT EXISTS ${three_archive})
      string(REGEX MATCH "reason: [^\n]*" reason "${told}")
      set(Three_FAULT "npm could not fetch three ${Three_VERSION}, ${reason}")
    endif()
  else()
    set(Three_FAULT "npm, which fetches three.js, was not found")
  endif()
endif()

if(EXISTS ${three_archive})
  file(SHA256 ${three_archive} sha256)
  if(NOT sha256 STREQUAL three_sha256)
    set(Three_FAULT "${three_archive} is not three ${Three_VERSION}")
  elseif(NOT EXISTS ${Three_MODULE})
    file(ARCHIVE_EXTRACT INPUT ${three_archive} DESTINATION ${three_folder}
         PATTERNS package/build/three.module.min.js package/LICENSE)
  endif()
endif()

if(Three_FAULT)
  unset(Three_MODULE)
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Three REQUIRED_VARS Three_MODULE Three_LICENSE
                                  REASON_FAILURE_MESSAGE "${Three_FAULT}")
