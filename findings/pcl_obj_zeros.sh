#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: PCL 1.13.0 (Debian pcl-tools 1.13.0+dfsg-3).
# Expected: pcl_ply2obj converts a PLY file with doubles, or fails.
# Seen: it warns of each property, and writes an OBJ file with all faces, in which all points are 0 0 0.
# The exit code does not tell: it is 1, as it is for the floats that come out right. pcl_ply2pcd of the
# same package reads the doubles.
# Met: PLY files of this program have doubles.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install pcl-tools=1.13.0+dfsg-3 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

for kind in float double; do
  cat >$kind.ply <<PLY
ply
format ascii 1.0
element vertex 3
property $kind x
property $kind y
property $kind z
element face 1
property list uchar int vertex_indices
end_header
1 2 3
4 5 6
7 8 8
3 0 1 2
PLY
done
cat >wanted <<'TEXT'
float.ply to OBJ, exit code 1: v 1 2 3, v 4 5 6, v 7 8 8, f 1 2 3
double.ply to OBJ, exit code 1: v 0 0 0, v 0 0 0, v 0 0 0, f 1 2 3
double.ply to PCD, exit code 0: 1 2 3, 4 5 6, 7 8 8
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack:$work/root/usr/lib
joined() { sed 's/ *$//' | paste -sd, | sed 's/,/, /g'; }
ls -- pcl-tools*.deb
{
  for kind in float double; do
    code=0
    root/usr/bin/pcl_ply2obj $kind.ply $kind.obj >log 2>&1 || code=$?
    echo "$kind.ply to OBJ, exit code $code: $(grep '^[vf] ' $kind.obj | joined)"
  done
  code=0
  root/usr/bin/pcl_ply2pcd -format 0 double.ply double.pcd >log 2>&1 || code=$?
  echo "double.ply to PCD, exit code $code: $(sed '1,/^DATA/d' double.pcd | joined)"
} | tee seen
diff wanted seen
