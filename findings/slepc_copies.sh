#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: SLEPc 3.18.2 (Debian python3-slepc4py-real3.18 3.18.2-1), PETSc 3.18.5.
# Expected: the solver of SLEPc, Krylov-Schur, at its default tolerance of 1e-8, finds all copies of an
# eigenvalue, or counts fewer as converged.
# Seen: of a matrix whose eigenvalues have four copies each, the twelve largest lack copies in each of
# twenty starts; later eigenvalues stand in their places, and all count as converged. A start vector has
# one direction of each eigenspace. Rounding brings the others in, and the tolerance is met before. At
# 1e-14 all copies are there.
# Met: the eigenvalues of the Dirac operator have four copies each; an adapter for SLEPc is part of this
# project.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install python3-slepc4py-real3.18=3.18.2-1 \
    python3-petsc4py-real3.18=3.18.5-1 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >copies.py <<'PY'
import numpy
from petsc4py import PETSc
from slepc4py import SLEPc

print("SLEPc %d.%d.%d, PETSc %d.%d.%d" % (SLEPc.Sys.getVersion() + PETSc.Sys.getVersion()))
size, wanted = 400, [100] * 4 + [99] * 4 + [98] * 4
A = PETSc.Mat().createAIJ([size, size], nnz=1)
for i in range(size):
    A[i, i] = 1 + i // 4
A.assemble()
for tolerance in (None, 1e-14):
    complete = converged = 0
    for seed in range(20):
        solver = SLEPc.EPS().create()
        solver.setOperators(A)
        solver.setProblemType(SLEPc.EPS.ProblemType.HEP)
        solver.setDimensions(12)
        solver.setWhichEigenpairs(SLEPc.EPS.Which.LARGEST_REAL)
        solver.setTolerances(tolerance)
        start = A.createVecRight()
        start.setArray(numpy.random.default_rng(seed).normal(size=size))
        solver.setInitialSpace([start])
        solver.solve()
        converged += solver.getConverged() >= 12
        complete += [round(solver.getEigenvalue(k).real, 6) for k in range(12)] == wanted
    print("tolerance", tolerance or "by default", ": converged in", converged, "of 20, complete in", complete)
PY
cat >wanted <<'TEXT'
SLEPc 3.18.2, PETSc 3.18.5
tolerance by default : converged in 20 of 20, complete in 0
tolerance 1e-14 : converged in 20 of 20, complete in 20
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
for folder in root/usr/lib/{slepc,petsc}dir/*/*-real; do
  LD_LIBRARY_PATH=$work/$folder/lib:$LD_LIBRARY_PATH
  PYTHONPATH=$work/$folder/lib/python3/dist-packages:$PYTHONPATH
done
{ /usr/bin/python3 copies.py || true; } | tee seen
diff wanted seen
