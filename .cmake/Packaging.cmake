# Copyright (c) 2026 The Conformal Geometry Processing authors
# SPDX-License-Identifier: LGPL-3.0-or-later
# Install, and what find_package(Conformal_geometry_processing COMPONENTS core cholmod metis slepc)
# reads.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# A library of headers is the same on every architecture, hence share/ and not lib/.
set(config_folder ${CMAKE_INSTALL_DATADIR}/cmake/${PROJECT_NAME})
set(config ${PROJECT_BINARY_DIR}/${PROJECT_NAME}Config.cmake)
set(config_version ${PROJECT_BINARY_DIR}/${PROJECT_NAME}ConfigVersion.cmake)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/Config.cmake.in ${config}
                              INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(${config_version} COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)

install(TARGETS cgp_core EXPORT core FILE_SET HEADERS COMPONENT headers)
install(EXPORT core NAMESPACE ${PROJECT_NAME}:: DESTINATION ${config_folder}
        FILE core_targets.cmake COMPONENT headers)
# An export set each, so that a user of core alone never needs SuiteSparse, METIS or MPI.
foreach(part cholmod metis slepc)
  if(TARGET cgp_${part})
    install(TARGETS cgp_${part} EXPORT ${part} FILE_SET HEADERS COMPONENT headers)
    install(EXPORT ${part} NAMESPACE ${PROJECT_NAME}:: DESTINATION ${config_folder}
            FILE ${part}_targets.cmake COMPONENT headers)
  endif()
endforeach()
install(FILES ${config} ${config_version} ${CMAKE_CURRENT_LIST_DIR}/FindCHOLMOD.cmake
              ${CMAKE_CURRENT_LIST_DIR}/FindMETIS.cmake ${CMAKE_CURRENT_LIST_DIR}/FindSLEPc.cmake
        DESTINATION ${config_folder} COMPONENT headers)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/doc/licenses/ DESTINATION ${CMAKE_INSTALL_DOCDIR}
        COMPONENT headers)
