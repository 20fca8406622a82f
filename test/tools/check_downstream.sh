#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# Builds and runs test/downstream/ as a user of the library would.
# usage: check_downstream.sh installed|packages|subdirectory BUILD_FOLDER COMPILER GENERATOR
set -euo pipefail

way=$1 build=$2 compiler=$3 generator=$4
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

arguments=(-S "$root/test/downstream" -B "$work/build" -G "$generator"
           -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=Release)
if [ "$way" = installed ]; then
  for component in libraries headers; do
    cmake --install "$build" --component $component --prefix "$work/prefix" >>"$work/log"
  done
  arguments+=(-DCMAKE_PREFIX_PATH="$work/prefix")
elif [ "$way" = packages ]; then # unpacked as root would install them
  (cd "$work" && cpack -G DEB --config "$build/CPackConfig.cmake" >"$work/log" 2>&1) ||
    { cat "$work/log"; exit 1; }
  for package in "$work"/*.deb; do
    dpkg-deb --field "$package" Package Depends
    dpkg-deb --extract "$package" "$work/prefix"
  done
  "$work/prefix/usr/bin/conformal" --version
  arguments+=(-DCMAKE_PREFIX_PATH="$work/prefix/usr")
else
  # The libraries are compiled with it, which is not worth optimizing here, and is half of the work
  # for clang++. Nothing is inlined: what a compiler has left out is missing at the end.
  arguments+=(-DSUBDIRECTORY="$root" -DCMAKE_CXX_FLAGS_RELEASE=-O0 -DBUILD_SHARED_LIBS=OFF)
fi

cmake "${arguments[@]}" >>"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
cmake --build "$work/build" --parallel 2 >>"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
if [ "$way" != subdirectory ] && command -v pkg-config >/dev/null; then # without CMake
  export PKG_CONFIG_PATH
  PKG_CONFIG_PATH=$(dirname "$(find "$work/prefix" -name conformal_geometry_kernels.pc)")
  read -ra flags <<<"$(pkg-config --cflags --libs conformal_geometry_kernels)"
  "$compiler" -std=c++17 "$root/test/downstream/kernels.cpp" "${flags[@]}" -o "$work/build/downstream_pkg_config" \
    "-Wl,-rpath,$(pkg-config --variable=libdir conformal_geometry_kernels)"
fi
if [ "$way" = installed ]; then # the component's headers are there, and it says what they need
  mkdir "$work/slepc"
  printf '%s\n' 'cmake_minimum_required(VERSION 3.23)' 'project(slepc LANGUAGES CXX)' \
    'find_package(Conformal_geometry_processing REQUIRED COMPONENTS slepc)' >"$work/slepc/CMakeLists.txt"
  ! cmake -S "$work/slepc" -B "$work/slepc/build" -DCMAKE_PREFIX_PATH="$work/prefix" \
    -DCMAKE_DISABLE_FIND_PACKAGE_SLEPc=ON >"$work/refusal" 2>&1
  grep -q 'slepc needs SLEPc' "$work/refusal" || { cat "$work/refusal"; exit 1; }
fi
for program in "$work"/build/downstream_*; do
  "$program"
done
