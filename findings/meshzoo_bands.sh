#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: meshzoo 0.9.4 (Debian python3-meshzoo 0.9.4-1).
# Expected: a band with an even number of half twists has two sides, and its triangles agree on one.
# Seen: neighbours disagree along half of its edges; the package's other surfaces agree along all.
# Met: bands and rings as test surfaces with a boundary.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install python3-meshzoo=0.9.4-1 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >band.py <<'PY'
from collections import Counter

import meshzoo

print("meshzoo", meshzoo.__version__)
bands = {"tube": meshzoo.tube(length=1.0, radius=1.0, n=12), "disk": meshzoo.disk(6, 5)}
for twists in (0, 2):
    bands[f"band of {twists} half twists"] = meshzoo.moebius(num_twists=twists, nl=40, nw=6)
for name, (_, faces) in bands.items():
    sides = Counter(side for a, b, c in faces.tolist() for side in ((a, b), (b, c), (c, a)))
    edges = Counter(tuple(sorted(side)) for side in sides.elements())
    print(f"{name}: neighbours disagree along {list(sides.values()).count(2)} of "
          f"{list(edges.values()).count(2)} edges")
PY
cat >wanted <<'TEXT'
meshzoo 0.9.4
tube: neighbours disagree along 0 of 24 edges
disk: neighbours disagree along 0 of 210 edges
band of 0 half twists: neighbours disagree along 280 of 560 edges
band of 2 half twists: neighbours disagree along 280 of 560 edges
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
/usr/bin/python3 band.py | tee seen
diff wanted seen
