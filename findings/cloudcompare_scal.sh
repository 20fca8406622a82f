#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: CloudCompare 2.11.3 (Debian cloudcompare 2.11.3-7.1+b1).
# Expected: on the command line it keeps all vertex properties of a PLY file, or none.
# Seen: it keeps those whose names contain "scal". Its window asks which properties are scalar fields;
# without a window that guess is the answer. A field gets "scalar_" before its name each time it is
# written, and coordinates become floats.
# Met: rho and quality do not pass through a batch of CloudCompare unless they are renamed.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install cloudcompare=2.11.3-7.1 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >mesh.ply <<'PLY'
ply
format ascii 1.0
element vertex 3
property double x
property double y
property double z
property double rho
property double scale
property double rescaled
property double quality
element face 1
property list uchar int vertex_indices
end_header
0 0 0 1 2 3 4
1 0 0 5 6 7 8
0 1 0 9 10 11 12
3 0 1 2
PLY
cat >wanted <<'TEXT'
comment Created by CloudCompare v2.11.3 (Anoia)
property float x
property float y
property float z
property float scalar_scale
property float scalar_rescaled
property list uchar int vertex_indices
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/cloudcompare QT_QPA_PLATFORM=offscreen
export QT_PLUGIN_PATH=$library/qt5/plugins
root/usr/bin/CloudCompare -SILENT -AUTO_SAVE OFF -NO_TIMESTAMP -O mesh.ply -M_EXPORT_FMT PLY \
  -SAVE_MESHES FILE out.ply >log 2>&1
strings -n 5 out.ply | grep -E '^(comment Created by|property)' | tee seen
diff wanted seen
