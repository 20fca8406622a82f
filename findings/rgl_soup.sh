#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: rgl 1.0.1 (Debian r-cran-rgl 1.0.1-1), R 4.2.2 (r-base-core 4.2.2.20221110-2).
# Expected: a closed indexed mesh of R leaves rgl as a closed surface: OBJ and PLY have indices.
# Seen: each triangle gets vertices of its own, so a tetrahedron arrives as four pieces with twelve
# vertices. In PLY colours are declared as floats and go from 0 to 255, where readers take floats from 0
# to 1.
# Met: surfaces out of R: --repair merges the vertices.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install r-cran-rgl=1.0.1-1 \
    r-base-core=4.2.2.20221110-2 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >soup.R <<'R'
library(rgl)
points <- rbind(c(0, 1, 0, 0), c(0, 0, 1, 0), c(0, 0, 0, 1))
faces <- rbind(c(1, 1, 2, 1), c(3, 2, 3, 4), c(2, 4, 4, 3))
mesh <- tmesh3d(points, faces, homogeneous = FALSE)
invisible(open3d())
invisible(shade3d(mesh, color = "#FF8040"))
cat("rgl", as.character(packageVersion("rgl")), "in memory:", ncol(mesh$vb), "vertices,", ncol(mesh$it), "faces\n")
writeOBJ("tetrahedron.obj")
cat("OBJ:", sum(grepl("^v ", readLines("tetrahedron.obj"))), "vertices\n")
writePLY("tetrahedron.ply", format = "ascii")
lines <- readLines("tetrahedron.ply")
row <- strsplit(lines[which(lines == "end_header") + 1], " ")[[1]]
cat("PLY:", trimws(grep("vertex [0-9]", lines, value = TRUE)), "\n")
cat("PLY:", grep("red", lines, value = TRUE), "=", row[4], "\n")
R
cat >wanted <<'TEXT'
rgl 1.0.1 in memory: 4 vertices, 4 faces
OBJ: 12 vertices
PLY: element vertex 12 
PLY: property float red = 255 
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export R_HOME=$work/root/usr/lib/R R_LIBS=$work/root/usr/lib/R/site-library
export LD_LIBRARY_PATH=$R_HOME/lib:$library:$library/blas:$library/lapack
# It looks for a file of settings at its installed place.
EDITOR=vi VISUAL=vi PAGER=cat RGL_USE_NULL=TRUE "$R_HOME/bin/exec/R" --no-save --slave --no-environ -f soup.R \
  2>&1 | grep -v "cannot find system Renviron" | tee seen
diff wanted seen
