#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: Open3D 0.16.1 (Debian python3-open3d 0.16.1+ds-2+b4).
# Expected: an OBJ file with quadrilaterals is read as its OFF and PLY twins are: cut into triangles.
# Seen: one quadrilateral among the faces, and the OBJ file is read as a mesh of no vertex and no face,
# without an exception or a warning; the twins have all triangles.
# Met: OBJ files that keep the polygons of their input, as those of this program do.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install python3-open3d=0.16.1+ds-2+b4 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >mesh.off <<'TEXT'
OFF
5 2 0
0 0 0
1 0 0
1 1 0
0 1 0
2 0 0
4 0 1 2 3
3 1 4 2
TEXT
{ sed -n '3,7s/^/v /p' mesh.off; echo f 1 2 3 4; echo f 2 5 3; } >mesh.obj
sed 's/f 1 2 3 4/f 1 2 3\nf 1 3 4/' mesh.obj >triangles.obj
cat >read.py <<'PY'
import open3d

print("Open3D", open3d.__version__)
open3d.utility.set_verbosity_level(open3d.utility.VerbosityLevel.Warning)
for name in ("mesh.off", "triangles.obj", "mesh.obj"):
    mesh = open3d.io.read_triangle_mesh(name)
    print(name, len(mesh.vertices), "vertices,", len(mesh.triangles), "triangles")
PY
cat >wanted <<'TEXT'
Open3D 0.16.1
mesh.off 5 vertices, 3 triangles
triangles.obj 5 vertices, 3 triangles
mesh.obj 0 vertices, 0 triangles
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
/usr/bin/python3 read.py 2>&1 | tee seen
diff wanted seen
