#!/bin/sh
# Copyright (c) 2026 The Conformal Geometry Processing authors
# SPDX-License-Identifier: LGPL-3.0-or-later
# Builds the readers with sanitizers and feeds them damaged files:
#   test/tools/fuzz_readers.sh [MUTANTS [SEED [SECONDS]]]
# CXX chooses the compiler (clang++ by default, where there is one), BUILD the folder.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
build=${BUILD:-${TMPDIR:-/tmp}/conformal_fuzz_readers}
if [ -z "${CXX:-}" ]; then
  CXX=g++
  if command -v clang++ >/dev/null; then CXX=clang++; fi
fi
mkdir -p "$build"
flags="-std=c++17 -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all"
objects=
for source in "$root"/examples/conformal/io/*.cpp "$root"/test/tools/fuzz_readers.cpp; do
  object=$build/$(basename "$source" .cpp).o
  "$CXX" $flags -I"$root/examples" -c "$source" -o "$object"
  objects="$objects $object"
done
"$CXX" $flags $objects -o "$build/fuzz_readers"
cd "$build"
# An allocation that no check stopped is a crash, not a refusal.
ASAN_OPTIONS=max_allocation_size_mb=256:allocator_may_return_null=0 exec ./fuzz_readers "$@"
