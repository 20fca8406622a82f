#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: OpenSceneGraph 3.6.5 (Debian openscenegraph 3.6.5+dfsg1-8+b2).
# Expected: osgconv from OBJ to OBJ leaves the points where they are.
# Seen: it turns them by a quarter about the x axis, (x, y, z) to (x, -z, y), each time: the reader
# takes y as up and turns to z, the writer does not turn back. Four conversions restore the surface. The
# reader has the option noRotation; that is not the default.
# Met: comparing a surface with its converted twin; a target or a formula in x, y, z fits only one of
# them.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install openscenegraph=3.6.5+dfsg1-8+b2 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >0.obj <<'OBJ'
v 0 0 0
v 1 0 0
v 0 2 0
v 0 0 3
f 1 3 2
f 1 2 4
f 2 3 4
f 1 4 3
OBJ
cat >wanted <<'TEXT'
OpenSceneGraph Library 3.6.5
0.obj: 0 0 0, 0 0 3, 0 2 0, 1 0 0
1.obj: 0 -3 0, 0 0 0, 0 0 2, 1 0 0
2.obj: 0 -2 0, 0 0 -3, 0 0 0, 1 0 0
3.obj: 0 0 -2, 0 0 0, 0 3 0, 1 0 0
4.obj: 0 0 0, 0 0 3, 0 2 0, 1 0 0
noRotation.obj: 0 0 0, 0 0 3, 0 2 0, 1 0 0
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library OSG_LIBRARY_PATH=$library/osgPlugins-3.6.5
convert() { root/usr/bin/osgconv "$@" >log 2>&1; }
for i in 0 1 2 3; do convert $i.obj $((i + 1)).obj; done
convert -O noRotation 0.obj noRotation.obj
{
  root/usr/bin/osgversion | head -1
  for file in {0,1,2,3,4,noRotation}.obj; do
    echo "$file: $(sed -n 's/^v //p' $file | sed 's/-0\>/0/g; s/ *$//' | LC_ALL=C sort -u | paste -sd, | sed 's/,/, /g')"
  done
} | tee seen
diff wanted seen
