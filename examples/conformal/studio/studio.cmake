# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# Puts the page of `conformal studio` into the target conformal_lib, or, where there is no emscripten or
# no three.js, the reason and what to do. em++ compiles to WebAssembly what the page needs of the program and of the
# libraries, which need Eigen's headers only.

set(studio_fault "")
set(CGP_HAS_STUDIO FALSE)
if(NOT CGP_STUDIO)
  set(studio_fault "it was configured without CGP_STUDIO")
elseif(NOT CGP_HAS_THREE)
  set(studio_fault "${Three_FAULT}")
else()
  find_program(CGP_EMXX em++)
  mark_as_advanced(CGP_EMXX)
  if(CGP_EMXX)
    set(CGP_HAS_STUDIO TRUE)
  else()
    set(studio_fault "em++ was not found; on Debian: apt-get install emscripten")
  endif()
endif()

cgp_build_advice("-DCGP_STUDIO=ON -DCGP_HTML_REPORT=ON" "about ten minutes, most of them for emscripten" studio_advice emscripten
                 npm)
set(studio_arguments -D "FAULT=${studio_fault}" -D "ADVICE=${studio_advice}")
set(studio_parts "")
if(CGP_HAS_STUDIO)
  # Debian's emscripten finds its JavaScript libraries with Debian's Node.js alone.
  set(emxx ${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs ${CGP_EMXX} -std=c++17 -O2
           -fwasm-exceptions -msimd128)
  get_target_property(json_folders nlohmann_json::nlohmann_json INTERFACE_INCLUDE_DIRECTORIES)
  set(folders -I${PROJECT_SOURCE_DIR}/include -I${CMAKE_CURRENT_SOURCE_DIR})
  foreach(folder IN LISTS EIGEN3_INCLUDE_DIRS)
    list(APPEND folders -isystem ${folder})
  endforeach()
  foreach(folder IN LISTS json_folders Boost_INCLUDE_DIRS) # behind those of emscripten, whose C library it must not hide
    list(APPEND folders -idirafter ${folder})
  endforeach()
  include(Reached_files)
  file(GLOB_RECURSE candidates CONFIGURE_DEPENDS ${CGP_INCLUDE}/*.cpp)
  list(APPEND candidates ${program_sources} ${io_sources})
  cgp_reached(reached ${CMAKE_CURRENT_LIST_DIR}/wasm/kernels.cpp "${candidates}")
  list(FILTER reached INCLUDE REGEX "\\.cpp$")
  list(SORT reached)
  set(sources "")
  foreach(part program library) # apart, so that a new file of the one leaves the other as it is
    set(files ${reached})
    if("${part}" STREQUAL "program")
      list(FILTER files EXCLUDE REGEX "^${CGP_INCLUDE}/")
      set(together 12)
    else()
      list(FILTER files INCLUDE REGEX "^${CGP_INCLUDE}/")
      set(together ${CGP_LIBRARY_FILES_TOGETHER})
    endif()
    set(number 0)
    while(files) # some files are one unit, as in the libraries
      list(SUBLIST files 0 ${together} some)
      list(REMOVE_ITEM files ${some})
      list(TRANSFORM some REPLACE "(.+)" "#include \"\\1\"\n")
      list(JOIN some "" content)
      set(unit ${CMAKE_CURRENT_BINARY_DIR}/${part}_${number}.cpp)
      file(CONFIGURE OUTPUT ${unit} CONTENT "${content}" @ONLY)
      list(APPEND sources ${unit})
      math(EXPR number "${number} + 1")
    endwhile()
  endforeach()
  set(objects "")
  foreach(source IN LISTS sources)
    cmake_path(GET source STEM name)
    set(object ${CMAKE_CURRENT_BINARY_DIR}/wasm_${name}.o)
    add_custom_command(OUTPUT ${object}
                       COMMAND ${emxx} -DNDEBUG -DEIGEN_MAX_ALIGN_BYTES=16 -DEIGEN_MALLOC_ALREADY_ALIGNED=0
                               ${folders} -MMD -MF ${object}.d -MT ${object} -c ${source} -o ${object}
                       DEPENDS ${source} DEPFILE ${object}.d VERBATIM
                       COMMENT "Compiling ${name}.cpp to WebAssembly")
    list(APPEND objects ${object})
  endforeach()
  set(kernels ${CMAKE_CURRENT_BINARY_DIR}/studio_kernels.js)
  add_custom_command(OUTPUT ${kernels}
                     COMMAND ${emxx} ${objects} -o ${kernels} -sMODULARIZE=1
                             -sEXPORT_NAME=makeKernels -sENVIRONMENT=web,worker -sSINGLE_FILE=1
                             -sALLOW_MEMORY_GROWTH=1 -sFILESYSTEM=0 -sDYNAMIC_EXECUTION=0
                             "-sEXPORTED_FUNCTIONS=['_malloc','_free']"
                             "-sEXPORTED_RUNTIME_METHODS=['UTF8ToString']"
                     DEPENDS ${objects} VERBATIM COMMENT "Linking the kernels of the studio")
  set(studio_arguments -D THREE=${Three_MODULE} -D LICENSE=${Three_LICENSE} -D KERNELS=${kernels})
  set(studio_parts ${Three_MODULE} ${kernels})
else()
  message(STATUS "conformal is built without the studio: ${studio_fault}")
endif()

set(studio_page ${CMAKE_CURRENT_BINARY_DIR}/studio_page.cpp)
file(GLOB studio_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/page/*
     ${CMAKE_CURRENT_LIST_DIR}/../report/html/*)
add_custom_command(OUTPUT ${studio_page}
                   COMMAND ${CMAKE_COMMAND} -D OUTPUT=${studio_page} -D PREFIX=${CMAKE_INSTALL_PREFIX}
                           ${studio_arguments}
                           -P ${CMAKE_CURRENT_LIST_DIR}/page/join.cmake
                   DEPENDS ${studio_sources} ${studio_parts} VERBATIM)
target_sources(conformal_lib PRIVATE ${studio_page})
