#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# Builds and runs test/downstream/ as a user of the library would.
# usage: check_downstream.sh installed|packages|subdirectory BUILD_FOLDER COMPILER GENERATOR
set -euo pipefail

way=$1 build=$2 compiler=$3 generator=$4
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# Whether this system lets root put a layer over it: containers mostly do not.
may_have_layers() {
  [ "$(id -u)" -eq 0 ] && mkdir "$work/layer" && unshare --mount bash -ec '
    mount -t tmpfs tmpfs "$1"
    mkdir "$1/new" "$1/work" "$1/root"
    mount -t overlay overlay -o "lowerdir=/,upperdir=$1/new,workdir=$1/work" "$1/root"
  ' bash "$work/layer" 2>/dev/null
}

# Installs packages as root does, in a layer over this system that goes with the process, uses and removes them.
install_in_a_layer() {
  printf '%s\n' OFF '4 4 0' '0 0 0' '1 0 0' '0 1 0' '0 0 1' '3 0 2 1' '3 0 1 3' '3 1 2 3' '3 0 3 2' >"$work/a.off"
  unshare --mount bash -ec '
    layer=$1 mesh=$2
    mount -t tmpfs tmpfs "$layer"
    mkdir "$layer/new" "$layer/work" "$layer/root"
    mount -t overlay overlay -o "lowerdir=/,upperdir=$layer/new,workdir=$layer/work" "$layer/root"
    cp "$mesh" "${@:3}" "$layer/root/root"
    chroot "$layer/root" bash -ec "
      cd /root
      dpkg --install *.deb
      conformal spin a.off --rho-expression 0 -o b.ply
      if dpkg --status python3-conformal-geometry; then /usr/bin/python3 -c \"import conformal_geometry\"; fi
      dpkg --remove conformal
      ! test -e /usr/bin/conformal"
  ' bash "$work/layer" "$work/a.off" "$@"
}

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
  if may_have_layers; then
    install_in_a_layer "$work"/*.deb >>"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
  else
    echo "not installed: that takes root, and a system that lets it mount"
  fi
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
