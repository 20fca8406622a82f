#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: GTS 0.7.6 (Debian libgts-bin 0.7.6+darcs121130-5+b1).
# Expected: the same program writes the same file for the same input.
# Seen: ten runs of stl2gts on one file write different files: vertices, edges and faces come in the order
# of their places in memory, which the system draws anew. Without that they are equal.
# Met: values by vertex, such as rho, do not fit a mesh that is made again; neither do hashes of files.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install libgts-bin=0.7.6+darcs121130-5+b1 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

# an octahedron
{
  echo "solid octahedron"
  for x in 1 -1; do for y in 1 -1; do for z in 1 -1; do
    first="vertex $x 0 0" second="vertex 0 $y 0"
    if ((x * y * z < 0)); then first="vertex 0 $y 0" second="vertex $x 0 0"; fi
    printf 'facet normal 0 0 0\nouter loop\n%s\n%s\nvertex 0 0 %s\nendloop\nendfacet\n' "$first" "$second" "$z"
  done; done; done
  echo "endsolid octahedron"
} >octahedron.stl
cat >wanted <<'TEXT'
vertices, edges, faces: 6 12 8
the files of ten runs are the same: no
with memory at the same places: yes
TEXT

export LD_LIBRARY_PATH=$work/root/usr/lib/$(gcc -dumpmachine)
are_the_same() {
  local -i files
  files=$(for run in {1..10}; do "$@" root/usr/bin/stl2gts <octahedron.stl | md5sum; done | sort -u | wc -l)
  if ((files == 1)); then echo yes; else echo no; fi
}
{
  echo "vertices, edges, faces: $(root/usr/bin/stl2gts <octahedron.stl | head -1 | cut -d' ' -f1-3)"
  echo "the files of ten runs are the same: $(are_the_same env)"
  echo "with memory at the same places: $(are_the_same setarch -R)"
} | tee seen
diff wanted seen
