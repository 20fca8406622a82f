# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# Defines SLEPc::SLEPc: SLEPc and PETSc for complex numbers, with MPI. Both come with files for
# pkg-config; those of an installation of one's own are found by way of PKG_CONFIG_PATH.

find_package(PkgConfig QUIET)
find_package(MPI QUIET COMPONENTS CXX)
if(PkgConfig_FOUND)
  pkg_check_modules(PC_SLEPC QUIET slepc)
endif()

set(SLEPC_IS_COMPLEX FALSE)
foreach(folder IN LISTS PC_SLEPC_INCLUDE_DIRS)
  if(EXISTS ${folder}/petscconf.h)
    file(STRINGS ${folder}/petscconf.h complex REGEX "define PETSC_USE_COMPLEX 1")
    if(complex)
      set(SLEPC_IS_COMPLEX TRUE)
    endif()
  endif()
endforeach()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(
  SLEPc REQUIRED_VARS PC_SLEPC_LINK_LIBRARIES PC_SLEPC_INCLUDE_DIRS SLEPC_IS_COMPLEX MPI_CXX_FOUND
  VERSION_VAR PC_SLEPC_VERSION)

# Without the compiler options of the .pc files, which are those PETSc was built with.
if(SLEPc_FOUND AND NOT TARGET SLEPc::SLEPc)
  add_library(SLEPc::SLEPc INTERFACE IMPORTED)
  set_target_properties(SLEPc::SLEPc PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${PC_SLEPC_INCLUDE_DIRS}"
    INTERFACE_LINK_LIBRARIES "${PC_SLEPC_LINK_LIBRARIES};MPI::MPI_CXX")
endif()
