#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: Blender 3.4.1 (Debian blender 3.4.1+dfsg-2+b1).
# Expected: a sphere of 42 vertices is a PLY file of 42 vertices: the format lets faces share them.
# Seen: 61 vertices. A mesh of Blender has texture coordinates at the corners of its faces, PLY at
# vertices, so that the exporter writes a vertex once for each texture coordinate that meets in it.
# Coordinates are the same to the digit, but the closed surface has a boundary. Without the texture
# coordinates it stays closed.
# Met: `conformal spin` and `flow` on meshes out of Blender: the seam gapes.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install blender=3.4.1+dfsg-2+b1 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >seams.py <<'PY'
import bpy

bpy.ops.wm.read_factory_settings(use_empty=True)
print("seen Blender", bpy.app.version_string)
bpy.ops.mesh.primitive_uv_sphere_add(segments=8, ring_count=6)
print("seen in Blender:", len(bpy.context.object.data.vertices), "vertices")
for uv in (True, False):
    bpy.ops.export_mesh.ply(filepath="sphere.ply", use_ascii=True, use_uv_coords=uv)
    lines = open("sphere.ply").read().split("\n")
    end = lines.index("end_header") + 1
    count = int(next(line for line in lines if line.startswith("element vertex")).split()[2])
    points = {tuple(line.split()[:3]) for line in lines[end:end + count]}
    print("seen", "with" if uv else "without", "texture coordinates:", count, "vertices at",
          len(points), "points")
PY
cat >wanted <<'TEXT'
Blender 3.4.1
in Blender: 42 vertices
with texture coordinates: 61 vertices at 42 points
without texture coordinates: 42 vertices at 42 points
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack:$work/root/usr/lib
export BLENDER_SYSTEM_SCRIPTS=$work/root/usr/share/blender/scripts
export BLENDER_SYSTEM_DATAFILES=$work/root/usr/share/blender/datafiles
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
root/usr/bin/blender --background --factory-startup --python seams.py 2>/dev/null |
  sed -n 's/^seen //p' | tee seen
diff wanted seen
