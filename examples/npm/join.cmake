# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# Lays out the npm package: what the page of the studio reads as scripts are modules there.
#
# usage: cmake -D PARTS=FOLDER -D PACKAGE=FOLDER -D KERNELS=FILE -D SURFACE=FILE -D LICENSE=FILE -P join.cmake

file(COPY ${PARTS}/index.js ${PARTS}/index.d.ts ${PARTS}/README.md ${PARTS}/example DESTINATION ${PACKAGE})
configure_file(${LICENSE} ${PACKAGE}/LICENSE COPYONLY)
file(READ ${SURFACE} surface)
file(WRITE ${PACKAGE}/surface.js "${surface}\nexport {OpenSurface, Refusal, readShape};\n")
file(READ ${KERNELS} kernels)
file(WRITE ${PACKAGE}/kernels.js "${kernels}\nexport default makeKernels;\n")
