#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: Assimp 5.2.5 (Debian assimp-utils 5.2.5~ds0-1+b1).
# Expected: "assimp export" writes a closed surface as a closed surface, from any format with indices.
# Seen: from OBJ each triangle comes with three vertices of its own, without a word, while the same
# surface from OFF or PLY keeps its vertices; only --join-identical-vertices mends it.
# Met: OBJ files that were converted have a boundary around each triangle.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install assimp-utils=5.2.5~ds0-1+b1 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >octahedron.off <<'TEXT'
OFF
6 8 0
1 0 0
0 1 0
0 0 1
-1 0 0
0 -1 0
0 0 -1
3 0 1 2
3 1 3 2
3 3 4 2
3 4 0 2
3 1 0 5
3 3 1 5
3 4 3 5
3 0 4 5
TEXT
awk 'NR > 2 && NF == 3 { print "v", $0 } NF == 4 { print "f", $2 + 1, $3 + 1, $4 + 1 }' octahedron.off >octahedron.obj
{
  printf 'ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n'
  printf 'element face 8\nproperty list uchar int vertex_indices\nend_header\n'
  tail -n +3 octahedron.off
} >octahedron.ply
cat >wanted <<'TEXT'
from off: element vertex 6
from ply: element vertex 6
from obj: element vertex 24
from obj, joined: element vertex 6
TEXT

export LD_LIBRARY_PATH=$work/root/usr/lib/$(gcc -dumpmachine)
export_to_ply() { root/usr/bin/assimp export "$1" out.ply "${@:2}" >/dev/null && grep 'element vertex' out.ply; }
for format in off ply obj; do echo "from $format: $(export_to_ply octahedron.$format)"; done | tee seen
echo "from obj, joined: $(export_to_ply octahedron.obj --join-identical-vertices)" | tee -a seen
diff wanted seen
