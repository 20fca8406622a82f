#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: OpenMesh 9.0 (Debian libopenmesh-dev 9.0-4+b1).
# Expected: a binary OFF file of OpenMesh is one of Geomview, whose format it is: each number has its
# most significant byte first, and the corners of a face are followed by the number of its colours.
# Seen: OpenMesh writes numbers as the machine has them, and no number of colours, under the same
# header, "OFF BINARY". A reader that keeps to the format takes 4 vertices for 67,108,864, and one that
# swaps bytes loses its place after the first face. Only OpenMesh reads the file.
# Met: readers of OFF; they cannot tell the two formats apart by the header.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install libopenmesh-dev=9.0-4+b1 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >mesh.off <<'TEXT'
OFF
4 4 6
0 0 0
1 0 0
0 1 0
0 0 1
3 0 2 1
3 0 1 3
3 1 2 3
3 0 3 2
TEXT
cat >write.cpp <<'CPP'
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

int main()
{
  OpenMesh::PolyMesh_ArrayKernelT<> mesh;
  OpenMesh::IO::Options binary = OpenMesh::IO::Options::Binary;
  return !(OpenMesh::IO::read_mesh(mesh, "mesh.off") &&
           OpenMesh::IO::write_mesh(mesh, "binary.off", binary));
}
CPP
cat >decode.py <<'PY'
import struct

header, data = open("binary.off", "rb").read().split(b"\n", 1)
print("header", header.decode())
print("numbers of vertices, faces, edges, most significant byte first:", *struct.unpack(">3i", data[:12]))
print("least significant byte first:", *struct.unpack("<3i", data[:12]))
print("after counts and points:", len(data) - 12 - 4 * 12, "bytes; with numbers of colours", 4 * 5 * 4)
PY
cat >wanted <<'TEXT'
header OFF BINARY
numbers of vertices, faces, edges, most significant byte first: 67108864 67108864 0
least significant byte first: 4 4 0
after counts and points: 64 bytes; with numbers of colours 80
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
g++ -std=c++17 -w -I root/usr/include write.cpp -L "$library" -lOpenMeshCore -o write
LD_LIBRARY_PATH=$library ./write
ls -- libopenmesh*.deb
/usr/bin/python3 decode.py | tee seen
diff wanted seen
