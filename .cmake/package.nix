# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
# The libraries for nix, from a checkout:
#   nix-build -E 'with import <nixpkgs> {}; callPackage ./.cmake/package.nix {}'
{ lib, stdenv, cmake, cgal, eigen, boost, gmp, mpfr }:

stdenv.mkDerivation {
  pname = "conformal-geometry-processing";
  version = "1.0.0";
  src = lib.cleanSource ./..;
  nativeBuildInputs = [ cmake ];
  propagatedBuildInputs = [ cgal eigen boost gmp mpfr ]; # which users' programs include and link
  cmakeFlags = map (part: "-DCGP_BUILD_${part}=OFF") [ "TESTS" "EXAMPLES" "BENCHMARKS" "DOC" ];
  meta = {
    description = "Surfaces edited, smoothed and flattened by their curvature, without shear";
    license = lib.licenses.lgpl3Plus;
  };
}
