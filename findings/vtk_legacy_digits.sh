#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: VTK 9.1.0 (Debian python3-vtk9 9.1.0+really9.1.0+dfsg2-5+deb12u1).
# Expected: the writer of VTK's own format keeps a double, as the writers of OBJ, STL and XML do.
# Seen: an ASCII file that is declared "POINTS 1 double" has eleven digits; XML, OBJ and STL files of
# the same points read back bit by bit. No property of the writer changes it.
# Met: coordinates for ParaView; a difference of two surfaces below 1e-11 of their size is lost.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install \
    python3-vtk9=9.1.0+really9.1.0+dfsg2-5+deb12u1 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >digits.py <<'PY'
import re
import vtkmodules.vtkIOGeometry as geometry
import vtkmodules.vtkIOLegacy as legacy
import vtkmodules.vtkIOXML as xml
from vtkmodules.vtkCommonCore import vtkPoints, vtkVersion
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

third, mesh, points, cells = 1 / 3, vtkPolyData(), vtkPoints(), vtkCellArray()
points.SetDataTypeToDouble()
for point in ((third, 0, 0), (third + 1, 0, 0), (third, 1, 0)):
    points.InsertNextPoint(point)
cells.InsertNextCell(3)
for i in range(3):
    cells.InsertCellPoint(i)
mesh.SetPoints(points)
mesh.SetPolys(cells)
print("VTK", vtkVersion.GetVTKVersion())
for writer, name in ((geometry.vtkSTLWriter(), "mesh.stl"), (geometry.vtkOBJWriter(), "mesh.obj"),
                     (xml.vtkXMLPolyDataWriter(), "mesh.vtp"),
                     (legacy.vtkPolyDataWriter(), "mesh.vtk")):
    writer.SetInputData(mesh)
    writer.SetFileName(name)
    if hasattr(writer, "SetDataModeToAscii"):
        writer.SetDataModeToAscii()
    writer.Write()
    number = re.search(r"0\.3333\d*", open(name).read()).group()
    print(name, number, "exact" if float(number) == third else "not exact")
PY
cat >wanted <<'TEXT'
VTK 9.1.0
mesh.stl 0.33333333333333331 exact
mesh.obj 0.3333333333333333 exact
mesh.vtp 0.3333333333333333 exact
mesh.vtk 0.33333333333 not exact
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
/usr/bin/python3 digits.py | tee seen
diff wanted seen
