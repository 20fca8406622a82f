# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
cmake_minimum_required(VERSION 3.12...3.25)
project(Conformal_geometry_processing_Examples)

find_package(CGAL REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE) # 3.4 or later; 5 refuses the number 3.4
find_package(Threads REQUIRED)
include(CGAL_Eigen3_support)
include_directories(BEFORE ../../include)

file(GLOB programs RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} *.cpp)
foreach(program ${programs})
  create_single_source_cgal_program(${program})
  get_filename_component(name ${program} NAME_WE)
  target_compile_features(${name} PRIVATE cxx_std_17)
  target_link_libraries(${name} PRIVATE CGAL::Eigen3_support Threads::Threads)
endforeach()
