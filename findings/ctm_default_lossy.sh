#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: OpenCTM 1.0.3 (Debian openctm-tools 1.0.3+dfsg1-2.1+b3).
# Expected: ctmconv, asked for nothing else, keeps a mesh of floats: the format has methods without loss
# (RAW, MG1) and one with (MG2).
# Seen: the default is MG2. Points move to a grid, by hundredths of an edge, and vertices and faces are
# sorted anew, so that nothing that was stored by vertex number fits any longer. --method MG1 keeps the
# points, bit by bit, and their order.
# Met: comparing surfaces before and after with vertices in their order.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install openctm-tools=1.0.3+dfsg1-2.1+b3 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >mesh.off <<'TEXT'
OFF
6 8 0
0.3 0 0
-0.7 0 0
0 0.9 0
0 -0.2 0
0 0 0.6
0 0 -0.4
3 0 2 4
3 2 1 4
3 1 3 4
3 3 0 4
3 2 0 5
3 1 2 5
3 3 1 5
3 0 3 5
TEXT
cat >wanted <<'TEXT'
before: 0.30000001 0 0, -0.69999999 0 0, 0 0.89999998 0, 0 -0.2 0, 0 0 0.60000002, 0 0 -0.40000001
MG1: 0.30000001 0 0, -0.69999999 0 0, 0 0.89999998 0, 0 -0.2 0, 0 0 0.60000002, 0 0 -0.40000001
default: -0.0025911462 -0.00017599761 -0.40000001, -0.69999999 -0.00017599761 0.0025031865, -0.0025911462 -0.2 0.0025031865, 0.29714486 -0.00017599761 0.0025031865, -0.0025911462 0.9022392 0.0025031865, -0.0025911462 -0.00017599761 0.59714484
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library
convert() { root/usr/bin/ctmconv "$@" >log; }
convert mesh.off before.ply
convert mesh.off mg1.ctm --method MG1
convert mg1.ctm MG1.ply
convert mesh.off default.ctm
convert default.ctm default.ply
ls -- openctm-tools*.deb
for name in before MG1 default; do
  echo "$name: $(sed '1,/^end_header/d' $name.ply | head -6 | paste -sd, | sed 's/,/, /g')"
done | tee seen
diff wanted seen
