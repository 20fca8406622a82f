# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# An overlay port of the checkout that it lies in:
#   vcpkg install conformal-geometry-processing --overlay-ports=CHECKOUT/.cmake/vcpkg

get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS -DCGP_BUILD_TESTS=OFF -DCGP_BUILD_EXAMPLES=OFF -DCGP_BUILD_BENCHMARKS=OFF
          -DCGP_BUILD_DOC=OFF)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME Conformal_geometry_processing
                         CONFIG_PATH lib/cmake/Conformal_geometry_processing)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/doc/licenses/LGPL-3.0-or-later.txt")
