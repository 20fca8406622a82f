#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: Gmsh 4.8.4 (Debian gmsh 4.8.4+ds2-3).
# Expected: a PLY file that Gmsh reads as text is read in binary, too: the header tells each type.
# Seen: binary files are read only if a vertex is three floats. Doubles, or one more property, end in
# "Wrong node index" and a mesh without nodes. The same files as text are read, and each further
# property becomes a view.
# Met: the program writes binary PLY with doubles and with the properties rho and quality.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install gmsh=4.8.4+ds2-3 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >write.py <<'PY'
import struct

points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
for kind, code in (("float", "f"), ("double", "d")):
    for extra in ([], ["rho"]):
        names = ["x", "y", "z"] + extra
        for form in ("ascii", "binary_little_endian"):
            with open("-".join([form[:6], kind] + extra) + ".ply", "wb") as out:
                out.write("\n".join(
                    ["ply", f"format {form} 1.0", "element vertex 4"]
                    + [f"property {kind} {name}" for name in names]
                    + ["element face 4", "property list uchar int vertex_indices", "end_header", ""])
                    .encode())
                for point in points:
                    row = point + (.5,) * len(extra)
                    out.write(struct.pack(f"<{len(row)}{code}", *row) if form != "ascii"
                              else (" ".join(map(str, row)) + "\n").encode())
                for face in faces:
                    out.write(struct.pack("<B3i", 3, *face) if form != "ascii"
                              else ("3 %d %d %d\n" % face).encode())
PY
cat >wanted <<'TEXT'
ascii-double-rho: 4 nodes, 1 views
ascii-double: 4 nodes, 0 views
ascii-float-rho: 4 nodes, 1 views
ascii-float: 4 nodes, 0 views
binary-double-rho: 0 nodes, 0 views: Wrong node index
binary-double: 0 nodes, 0 views: Wrong node index
binary-float-rho: 0 nodes, 0 views: Wrong node index
binary-float: 4 nodes, 0 views
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack
/usr/bin/python3 write.py
root/usr/bin/gmsh --version
for file in ascii*.ply binary*.ply; do
  {
    echo "Merge \"$file\";"
    echo 'Printf("nodes %g views %g", Mesh.NbNodes, PostProcessing.NbViews);'
  } >read.geo
  root/usr/bin/gmsh -nopopup -parse_and_exit read.geo >log 2>&1 || true
  nodes=$(sed -n 's/.*nodes \([0-9]*\) views.*/\1/p' log)
  views=$(sed -n 's/.*views \([0-9]*\).*/\1/p' log)
  echo "${file%.ply}: $nodes nodes, $views views$(grep -o 'Wrong node index' log | sed '1s/^/: /;2,$d')"
done | tee seen
diff wanted seen
