# Copyright (c) 2026 The Conformal Geometry Processing authors
# SPDX-License-Identifier: LGPL-3.0-or-later
# Several sources as one, because what they instantiate takes longer to compile than they do
# themselves: their headers first, so that they are included no more inside, and then each file in a
# namespace of its own, which its names cannot leave.

# The lines that include, of all of these files, each once.
function(cgp_included_headers sources result)
  set(headers "")
  foreach(source IN LISTS sources)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
    file(STRINGS ${source} lines REGEX "^#include ")
    foreach(line IN LISTS lines)
      if(NOT line IN_LIST headers)
        list(APPEND headers "${line}")
      endif()
    endforeach()
  endforeach()
  list(JOIN headers "\n" text)
  set(${result} "${text}\n" PARENT_SCOPE)
endfunction()

# The anonymous namespaces of files that are included are those of the one that is compiled.
function(cgp_allow_joined_namespaces source)
  set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS
                              "$<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>")
endfunction()

# Writes <name>.cpp, the tests of several files.
function(cgp_join_tests name sources)
  cgp_included_headers("${sources}" content)
  string(APPEND content "namespace cgp_test {}\nnamespace program_test {}\n")
  set(number 0)
  foreach(source IN LISTS sources)
    math(EXPR number "${number} + 1")
    string(APPEND content "namespace file_${number} {\n"
                          "namespace cgp_test { using namespace ::cgp_test; }\n"
                          "namespace program_test { using namespace ::program_test; }\n"
                          "#include \"${source}\"\n}\n")
  endforeach()
  file(CONFIGURE OUTPUT ${name}.cpp CONTENT "${content}" @ONLY)
  cgp_allow_joined_namespaces(${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
endfunction()

# A program that is any of several: that by whose name it is called. Each has a link of its name.
function(cgp_join_programs name sources)
  cgp_included_headers("${sources}" content)
  string(APPEND content "#include <map>\n#include <string>\n")
  set(table "")
  set(links "")
  foreach(source IN LISTS sources)
    cmake_path(GET source STEM program)
    file(READ ${source} text)
    # Only the real main() may end without a return.
    string(FIND "${text}" "\n}" end REVERSE)
    string(SUBSTRING "${text}" 0 ${end} text)
    string(APPEND content "namespace ${program} {\n#line 1 \"${source}\"\n${text}\n"
                          "  return 0;\n}\n}\n")
    string(APPEND table "  {\"${program}\", ${program}::main},\n")
    list(APPEND links COMMAND ${CMAKE_COMMAND} -E create_symlink ${name} ${program})
  endforeach()
  string(APPEND content "#line 1 \"${name}.cpp\"\n"
         "int main(int argc, char* argv[])\n{\n"
         "  const std::map<std::string, int (*)(int, char**)> programs = {\n${table}  };\n"
         "  const std::string path = argv[0];\n"
         "  return programs.at(path.substr(path.rfind('/') + 1))(argc, argv);\n}\n")
  file(CONFIGURE OUTPUT ${name}.cpp CONTENT "${content}" @ONLY)
  add_executable(${name} ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  cgp_allow_joined_namespaces(${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  add_custom_command(TARGET ${name} POST_BUILD ${links} VERBATIM
                     WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
endfunction()
