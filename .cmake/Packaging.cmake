# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# Install, and what find_package(Conformal_geometry_processing COMPONENTS core cholmod metis slepc)
# reads.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/${PROJECT_NAME})
set(config ${PROJECT_BINARY_DIR}/${PROJECT_NAME}Config.cmake)
set(config_version ${PROJECT_BINARY_DIR}/${PROJECT_NAME}ConfigVersion.cmake)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/Config.cmake.in ${config}
                              INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(${config_version} COMPATIBILITY SameMajorVersion)

# The targets of a component, and the file that find_package reads for it:
# cgp_install(<component> <target>...)
function(cgp_install component)
  install(TARGETS ${ARGN} EXPORT ${component}
          LIBRARY COMPONENT libraries NAMELINK_COMPONENT headers
          RUNTIME COMPONENT libraries
          ARCHIVE COMPONENT headers
          FILE_SET HEADERS COMPONENT headers)
  install(EXPORT ${component} NAMESPACE ${PROJECT_NAME}:: DESTINATION ${config_folder}
          FILE ${component}_targets.cmake COMPONENT headers)
endfunction()

# An export set each, so that a user of kernels alone never needs CGAL, nor a user of core alone
# SuiteSparse, METIS or MPI.
cgp_install(kernels cgp_linear_algebra cgp_kernels)
if(TARGET cgp_core)
  cgp_install(core cgp_core)
endif()
foreach(part cholmod metis slepc)
  if(TARGET cgp_${part})
    cgp_install(${part} cgp_${part})
  endif()
endforeach()
install(FILES ${config} ${config_version} ${CMAKE_CURRENT_LIST_DIR}/FindCHOLMOD.cmake
              ${CMAKE_CURRENT_LIST_DIR}/FindMETIS.cmake ${CMAKE_CURRENT_LIST_DIR}/FindSLEPc.cmake
        DESTINATION ${config_folder} COMPONENT headers)
# For projects without CMake: `pkg-config conformal_geometry_kernels`.
set(pc_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH pc_prefix /${pc_folder} /)
configure_file(${CMAKE_CURRENT_LIST_DIR}/conformal_geometry_kernels.pc.in
               ${PROJECT_BINARY_DIR}/conformal_geometry_kernels.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/conformal_geometry_kernels.pc DESTINATION ${pc_folder}
        COMPONENT headers)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/doc/licenses/ DESTINATION ${CMAKE_INSTALL_DOCDIR}
        COMPONENT headers)

# Debian packages: `cpack -G DEB` makes libconformal-geometry-processing, -dev, conformal and
# python3-conformal-geometry.
set(CPACK_PACKAGE_NAME conformal-geometry-processing)
set(CPACK_PACKAGE_VENDOR "The Conformal Geometry Processing authors")
set(CPACK_PACKAGE_CONTACT "${CPACK_PACKAGE_VENDOR} <authors@conformal-geometry-processing.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "surfaces edited, smoothed and flattened by their curvature")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/doc/licenses/LGPL-3.0-or-later.txt)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_COMPONENTS_ALL libraries headers)
if(CGP_BUILD_EXAMPLES)
  list(APPEND CPACK_COMPONENTS_ALL program)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR})
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_NAME libconformal-geometry-processing)
set(CPACK_DEBIAN_LIBRARIES_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_HEADERS_PACKAGE_NAME libconformal-geometry-processing-dev)
set(CPACK_DEBIAN_HEADERS_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_HEADERS_PACKAGE_DEPENDS "libcgal-dev (>= 5.5), libeigen3-dev (>= 3.4)")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME conformal)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION graphics)
set(CPACK_COMPONENT_HEADERS_DEPENDS libraries)
set(CPACK_COMPONENT_PROGRAM_DEPENDS libraries)
set(CPACK_DEBIAN_PYTHON_DEBIAN_PACKAGE_NAME python3-conformal-geometry)
set(CPACK_DEBIAN_PYTHON_DEBIAN_PACKAGE_SECTION python)
set(CPACK_COMPONENT_PYTHON_DEBIAN_DEPENDS libraries)
if(PROJECT_IS_TOP_LEVEL)
  cmake_language(DEFER CALL include CPack) # when it is known whether there is a Python module
endif()
