# Copyright (c) 2026 The Conformal Geometry Processing authors
# SPDX-License-Identifier: LGPL-3.0-or-later
# The targets users link: Conformal_geometry_processing::core, every header except those over
# CHOLMOD, METIS and SLEPc, and Conformal_geometry_processing::cholmod, ::metis and ::slepc, which
# add them and the library.

cgp_find(CGP_HAS_CGAL libcgal-dev CGAL 5.5 QUIET)
# NO_MODULE: CGAL puts a FindEigen3.cmake of its own on the module path.
cgp_find(CGP_HAS_EIGEN libeigen3-dev Eigen3 3.4 QUIET NO_MODULE)
find_package(Threads REQUIRED)
cgp_find(CGP_HAS_CHOLMOD libsuitesparse-dev CHOLMOD QUIET MODULE)
cgp_find(CGP_HAS_METIS libmetis-dev METIS QUIET MODULE)
cgp_find(CGP_HAS_SLEPC libslepc-complex-dev SLEPc QUIET MODULE)
if(NOT CGP_HAS_CGAL OR NOT CGP_HAS_EIGEN)
  message(FATAL_ERROR "Conformal Geometry Processing needs CGAL 5.5 or later and Eigen 3.4; "
                      "on Debian: apt-get install libcgal-dev libeigen3-dev")
endif()

function(cgp_add_library name) # the remaining arguments are the headers
  add_library(cgp_${name} INTERFACE)
  add_library(Conformal_geometry_processing::${name} ALIAS cgp_${name})
  set_target_properties(cgp_${name} PROPERTIES EXPORT_NAME ${name}
                        VERIFY_INTERFACE_HEADER_SETS ON) # every header compiles alone
  target_sources(cgp_${name} INTERFACE FILE_SET HEADERS
                 BASE_DIRS ${PROJECT_SOURCE_DIR}/include FILES ${ARGN})
  target_compile_features(cgp_${name} INTERFACE cxx_std_17)
endfunction()

file(GLOB_RECURSE CGP_CORE_HEADERS CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/include/*.h)
set(CGP_CHOLMOD_HEADERS ${CGP_CORE_HEADERS})
set(CGP_METIS_HEADERS ${CGP_CORE_HEADERS})
set(CGP_SLEPC_HEADERS ${CGP_CORE_HEADERS})
list(FILTER CGP_CORE_HEADERS EXCLUDE REGEX "/(Cholmod|Metis|Petsc|Slepc)_")
list(FILTER CGP_CHOLMOD_HEADERS INCLUDE REGEX "/Cholmod_")
list(FILTER CGP_METIS_HEADERS INCLUDE REGEX "/Metis_")
list(FILTER CGP_SLEPC_HEADERS INCLUDE REGEX "/(Petsc|Slepc)_")

cgp_add_library(core ${CGP_CORE_HEADERS})
target_link_libraries(cgp_core INTERFACE CGAL::CGAL Eigen3::Eigen Threads::Threads)
set(CGP_TARGETS cgp_core)

if(CGP_HAS_CHOLMOD)
  cgp_add_library(cholmod ${CGP_CHOLMOD_HEADERS})
  target_link_libraries(cgp_cholmod INTERFACE cgp_core CHOLMOD::CHOLMOD)
  target_compile_definitions(cgp_cholmod INTERFACE CONFORMAL_GEOMETRY_PROCESSING_USE_CHOLMOD)
  list(APPEND CGP_TARGETS cgp_cholmod)
endif()

if(CGP_HAS_METIS)
  cgp_add_library(metis ${CGP_METIS_HEADERS})
  target_link_libraries(cgp_metis INTERFACE cgp_core METIS::METIS)
  list(APPEND CGP_TARGETS cgp_metis)
endif()

if(CGP_HAS_SLEPC)
  cgp_add_library(slepc ${CGP_SLEPC_HEADERS})
  target_link_libraries(cgp_slepc INTERFACE cgp_core SLEPc::SLEPc)
  list(APPEND CGP_TARGETS cgp_slepc)
endif()
