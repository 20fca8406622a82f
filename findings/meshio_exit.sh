#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: meshio 5.0.0 (Debian python3-meshio 7.0.0-3).
# Expected: meshio.read() raises an exception, which a program can catch, for what it cannot read.
# Seen: it prints a line and calls sys.exit(1). `except Exception` does not catch that, and a server or
# a loop over files ends. An OFF file with a quadrilateral is enough, although meshio writes PLY and OBJ
# files with quadrilaterals and reads them.
# Met: OFF files with polygons, and PLY files with an empty element edge, which ends it likewise.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install python3-meshio=7.0.0-3 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >square.off <<'TEXT'
OFF
4 1 0
0 0 0
1 0 0
1 1 0
0 1 0
4 0 1 2 3
TEXT
cat >square.obj <<'OBJ'
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
f 1 2 3 4
OBJ
cat >read.py <<'PY'
import sys

import meshio

print("meshio", meshio.__version__)
for name in ("square.obj", "missing.off", "square.off"):
    try:
        print(name, meshio.read(name).cells_dict, flush=True)
    except Exception as error:
        print(name, "is not read:", type(error).__name__, flush=True)
print("the end is reached")
PY
cat >wanted <<'TEXT'
meshio 5.0.0
square.obj {'quad': array([[0, 1, 2, 3]])}
missing.off is not read: ReadError
exit code 1
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
{ /usr/bin/python3 read.py 2>/dev/null && echo "exit code 0" || echo "exit code $?"; } |
  grep -E 'meshio|square.obj|missing|exit code|end' | tee seen
diff wanted seen
