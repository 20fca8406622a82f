#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: Open3D 0.16.1 (Debian python3-open3d 0.16.1+ds-2+b4).
# Expected: Open3D reads the GLB file that it writes.
# Seen: it writes it, tells success, and reads no vertex from it, as other readers do: the file has one
# chunk, of JSON, whose buffer is a data URI in base64, while the format has a binary chunk for buffers.
# Its glTF file, with the same URI, is read.
# Met: GLB files out of Open3D as input of `conformal`.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install python3-open3d=0.16.1+ds-2+b4 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >glb.py <<'PY'
import json
import struct

import open3d

open3d.utility.set_verbosity_level(open3d.utility.VerbosityLevel.Error)
mesh = open3d.geometry.TriangleMesh.create_icosahedron()
print("Open3D", open3d.__version__)
for name in ("mesh.gltf", "mesh.glb"):
    written = open3d.io.write_triangle_mesh(name, mesh)
    read = open3d.io.read_triangle_mesh(name)
    print(name, "written:", written, "vertices read:", len(read.vertices))
with open("mesh.glb", "rb") as file:
    magic, version, size = struct.unpack("<4sII", file.read(12))
    length, kind = struct.unpack("<I4s", file.read(8))
    uri = json.loads(file.read(length))["buffers"][0]["uri"]
    print("first chunk", kind.decode(), "buffer", uri.split(",")[0], "bytes after it", len(file.read()))
PY
cat >wanted <<'TEXT'
Open3D 0.16.1
mesh.gltf written: True vertices read: 12
mesh.glb written: True vertices read: 0
first chunk JSON buffer data:application/octet-stream;base64 bytes after it 0
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
/usr/bin/python3 glb.py 2>/dev/null | tee seen
diff wanted seen
