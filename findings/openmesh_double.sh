#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: OpenMesh 9.0 (Debian libopenmesh-dev 9.0-4+b1).
# Expected: a mesh whose traits have points of doubles reads and writes doubles.
# Seen: with seventeen digits asked for, the points of PLY and OBJ files are floats, while a property of
# doubles in the same PLY file passes exactly: readers and writers hand points over as Vec3f. That type
# of a point stays "float" in the header.
# Met: exchange with programs on OpenMesh; rho arrives in full, the points that belong to it do not.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install libopenmesh-dev=9.0-4+b1 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >mesh.ply <<'PLY'
ply
format ascii 1.0
element vertex 3
property double x
property double y
property double z
property double rho
element face 1
property list uchar int vertex_indices
end_header
0.1 0 0 0.1
1 0 0 1
0 1 0 2
3 0 1 2
PLY
cat >convert.cpp <<'CPP'
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <cstdio>

struct Traits : OpenMesh::DefaultTraits
{
  typedef OpenMesh::Vec3d Point;
};

int main()
{
  OpenMesh::PolyMesh_ArrayKernelT<Traits> mesh;
  OpenMesh::IO::Options custom = OpenMesh::IO::Options::Custom;
  OpenMesh::IO::read_mesh(mesh, "mesh.ply", custom);
  std::printf("in memory, x: %.17g\n", mesh.point(*mesh.vertices_begin())[0]);
  mesh.set_point(*mesh.vertices_begin(), {0.1, 0, 0});
  OpenMesh::IO::write_mesh(mesh, "out.ply", OpenMesh::IO::Options::Custom, 17);
  OpenMesh::IO::write_mesh(mesh, "out.obj", OpenMesh::IO::Options::Default, 17);
}
CPP
cat >wanted <<'TEXT'
in memory, x: 0.10000000149011612
out.ply: property float x
out.ply: property double rho
out.ply: 0.10000000149011612 0 0 0.10000000000000001
out.obj: v 0.10000000149011612 0.00000000000000000 0.00000000000000000
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
g++ -std=c++17 -w -I root/usr/include convert.cpp -L "$library" -lOpenMeshCore -o convert
ls -- libopenmesh*.deb
{
  LD_LIBRARY_PATH=$library ./convert
  grep -HE ' x$|rho|^0\.1' out.ply | sed 's/ply:/ply: /'
  grep -H '^v 0.1' out.obj | sed 's/obj:/obj: /'
} | tee seen
diff wanted seen
