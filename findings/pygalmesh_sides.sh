#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: pygalmesh 0.10.6 (Debian python3-pygalmesh 0.10.6-1+b3).
# Expected: the triangles around a ball have one side outside, as CGAL's facets do: their signed volume is
# that of the ball.
# Seen: by generate_surface_mesh(). The triangles beside tetrahedra of generate_mesh() come twice, in
# both orientations (volume 0), and remesh_surface() turns its triangles this way and that.
# Met: surfaces from volumes, and remeshed ones, as input; "not oriented" is what CGAL says of them.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install python3-pygalmesh=0.10.6-1+b3 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >ball.py <<'PY'
from collections import Counter

import numpy
import pygalmesh

def tell(name, mesh):
    p = mesh.points - mesh.points.mean(0)
    t = next(cells.data for cells in mesh.cells if cells.type == "triangle")
    volume = numpy.einsum("ij,ij->i", p[t[:, 0]], numpy.cross(p[t[:, 1]], p[t[:, 2]])).sum() / 6
    sides = Counter(edge for a, b, c in t for edge in ((a, b), (b, c), (c, a)))
    triangles = Counter(tuple(sorted(corners)) for corners in t)
    print(f"{name}: volume {'right' if 3.7 < volume < 4.3 else 'wrong'},",
          f"{'some' if max(sides.values()) > 1 else 'no'} neighbours disagree,",
          f"each triangle {'/'.join(map(str, sorted(set(triangles.values()))))} times")
    return p, t


print("pygalmesh", pygalmesh.__version__)
ball = pygalmesh.Ball([0, 0, 0], 1)
points, faces = tell("generate_surface_mesh", pygalmesh.generate_surface_mesh(
    ball, min_facet_angle=30, max_radius_surface_delaunay_ball=.2, max_facet_distance=.1, verbose=False))
tell("generate_mesh", pygalmesh.generate_mesh(
    ball, max_cell_circumradius=.3, max_facet_distance=.05, verbose=False))
with open("ball.off", "w") as out:
    out.write(f"OFF\n{len(points)} {len(faces)} 0\n")
    out.writelines("%.17g %.17g %.17g\n" % tuple(p) for p in points)
    out.writelines("3 %d %d %d\n" % tuple(f) for f in faces)
tell("remesh_surface", pygalmesh.remesh_surface(
    "ball.off", max_edge_size_at_feature_edges=.2, min_facet_angle=25, max_radius_surface_delaunay_ball=.2,
    max_facet_distance=.05, verbose=False))
PY
cat >wanted <<'TEXT'
pygalmesh 0.10.6
generate_surface_mesh: volume right, no neighbours disagree, each triangle 1 times
generate_mesh: volume wrong, some neighbours disagree, each triangle 2 times
remesh_surface: volume wrong, some neighbours disagree, each triangle 1 times
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
/usr/bin/python3 ball.py | tee seen
diff wanted seen
