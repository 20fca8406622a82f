#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: nibabel 5.0.0 (Debian python3-nibabel 5.0.0-2).
# Expected: the encodings of GIFTI, the format of brain surfaces, hold the same 32-bit floats.
# Seen: base64 does. As text each number has six digits after the point, whatever its size: a coordinate
# is off by 3e-7, and a surface of micrometres in metres is zero. The header says NIFTI_TYPE_FLOAT32
# both times.
# Met: maps of brain surfaces to the sphere, where points that merge are faces of area zero.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install python3-nibabel=5.0.0-2 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >gifti.py <<'PY'
import nibabel
import numpy

print("nibabel", nibabel.__version__)
points = numpy.array([[.1234567, .7654321, 0], [1e-7, 2e-7, 3e-7]], numpy.float32)
for encoding in ("GIFTI_ENCODING_B64BIN", "GIFTI_ENCODING_ASCII"):
    array = nibabel.gifti.GiftiDataArray(points, intent="NIFTI_INTENT_POINTSET", encoding=encoding)
    nibabel.save(nibabel.gifti.GiftiImage(darrays=[array]), "surface.gii")
    read = nibabel.load("surface.gii").darrays[0].data
    print(encoding, "largest difference", f"{abs(read - points).max():.0e},",
          "second point zero:", not read[1].any())
PY
cat >wanted <<'TEXT'
nibabel 5.0.0
GIFTI_ENCODING_B64BIN largest difference 0e+00, second point zero: False
GIFTI_ENCODING_ASCII largest difference 3e-07, second point zero: True
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
/usr/bin/python3 gifti.py | tee seen
diff wanted seen
