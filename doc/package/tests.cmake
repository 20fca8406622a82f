# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
cmake_minimum_required(VERSION 3.12...3.25)
project(Conformal_geometry_processing_Tests)

find_package(CGAL REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE) # 3.4 or later; 5 refuses the number 3.4
find_package(Threads REQUIRED)
find_package(GTest QUIET)
if(NOT GTest_FOUND)
  message(STATUS "This project requires GoogleTest, and will not be compiled.")
  return()
endif()
include(CGAL_Eigen3_support)
include_directories(BEFORE ../../include ${CMAKE_CURRENT_SOURCE_DIR})
add_definitions(-DCGAL_CGP_SOURCE_DIR="${CMAKE_CURRENT_SOURCE_DIR}")

# What the tests share
file(GLOB shared support/*.cpp)
list(APPEND shared quaternionic_linear_algebra/hermitian_matrices.cpp spin/boundary_tools.cpp)
add_library(test_support STATIC ${shared})
target_compile_features(test_support PUBLIC cxx_std_17)
target_link_libraries(test_support PUBLIC CGAL::CGAL CGAL::Eigen3_support Threads::Threads
                      GTest::gtest_main)

file(GLOB_RECURSE programs RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} *.cpp)
list(FILTER programs EXCLUDE REGEX "^support/|hermitian_matrices|boundary_tools|CMakeFiles")
foreach(program ${programs})
  string(REGEX REPLACE "[/.]" "_" name ${program})
  get_filename_component(folder ${program} DIRECTORY)
  add_executable(${name} ${program})
  target_include_directories(${name} PRIVATE ${folder})
  target_link_libraries(${name} PRIVATE test_support)
  cgal_add_test(${name})
endforeach()
