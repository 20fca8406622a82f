#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: METIS 5.1.0 (Debian libmetis-dev 5.1.0.dfsg-7).
# Expected: METIS_PartGraphKway() divides a graph into as many parts as are asked for, as long as there are
# vertices enough.
# Seen: of a surface of 16 vertices in nine parts it leaves one empty, in sixteen eleven, and reports
# success. METIS_PartGraphRecursive() leaves none.
# Met: small surfaces, or small components, divided among processes.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install libmetis-dev=5.1.0.dfsg-7 libmetis5=5.1.0.dfsg-7 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >parts.c <<'C'
#include <metis.h>
#include <stdio.h>

enum { side = 4, size = side * side };

int main(void)
{
  idx_t first[size + 1] = {0}, next[4 * size], part[size], n = size, one = 1, cut;
  for(int k = 0, end = 0; k < size; ++k) {
    if(k % side > 0) next[end++] = k - 1;
    if(k % side + 1 < side) next[end++] = k + 1;
    if(k >= side) next[end++] = k - side;
    if(k + side < size) next[end++] = k + side;
    first[k + 1] = end;
  }
  printf("METIS %d.%d.%d\n", METIS_VER_MAJOR, METIS_VER_MINOR, METIS_VER_SUBMINOR);
  for(idx_t parts = 8; parts <= 16; parts += parts == 8 ? 1 : 7)
    for(int is_kway = 0; is_kway < 2; ++is_kway) {
      const int status =
        is_kway ? METIS_PartGraphKway(&n, &one, first, next, NULL, NULL, NULL, &parts, NULL, NULL, NULL, &cut, part)
                : METIS_PartGraphRecursive(&n, &one, first, next, NULL, NULL, NULL, &parts, NULL, NULL, NULL, &cut, part);
      int empty = 0;
      for(idx_t p = 0; p < parts; ++p) {
        int vertices = 0;
        for(int k = 0; k < size; ++k) vertices += part[k] == p;
        empty += vertices == 0;
      }
      printf("%d parts, %s: %s, %d empty\n", (int)parts, is_kway ? "k-way" : "recursive",
             status == METIS_OK ? "success" : "failure", empty);
    }
  return 0;
}
C
cat >wanted <<'TEXT'
METIS 5.1.0
8 parts, recursive: success, 0 empty
8 parts, k-way: success, 0 empty
9 parts, recursive: success, 0 empty
9 parts, k-way: success, 1 empty
16 parts, recursive: success, 0 empty
16 parts, k-way: success, 11 empty
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
gcc -w -I root/usr/include parts.c -L "$library" -l:libmetis.so.5 -Wl,-rpath,"$library" -lm -o parts
./parts | tee seen
diff wanted seen
