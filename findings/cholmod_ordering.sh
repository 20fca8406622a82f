#!/bin/bash
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#
# Versions: CHOLMOD 3.0.14 (Debian libsuitesparse-dev 1:5.12.0+dfsg-2).
# Expected: the default ordering of CHOLMOD, which may try AMD and METIS, takes the one with less fill
# for the graph of a surface, and the same one for one unknown and for four unknowns at each vertex.
# Seen: METIS is not tried while AMD needs less than 500 operations for each entry of the factor, and a
# surface of 40,962 vertices needs 266, although METIS has 24 % less fill there. With four unknowns at
# each vertex, a quarter of the vertices are enough for METIS.
# Met: the ordering of the Dirac matrix and of the Laplacian on the same mesh; ours is chosen otherwise.
set -euo pipefail

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get -o Debug::NoLocking=1 -o APT::Sandbox::User=root -o Dir::Cache::archives="$work/" --yes \
  --reinstall --no-install-recommends --download-only install libsuitesparse-dev=1:5.12.0+dfsg-2 \
    libcholmod3=1:5.12.0+dfsg-2 libmetis5 libamd2=1:5.12.0+dfsg-2 libcamd2=1:5.12.0+dfsg-2 \
    libcolamd2=1:5.12.0+dfsg-2 libccolamd2=1:5.12.0+dfsg-2 libsuitesparseconfig5=1:5.12.0+dfsg-2 >/dev/null
for package in *.deb; do dpkg-deb --extract "$package" root; done

cat >order.cpp <<'CPP'
#include <cholmod.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <vector>

int main()
{
  std::vector<std::array<long, 3>> faces = {
      {0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
      {11, 10, 2}, {10, 7, 6}, {7, 1, 8}, {3, 9, 4}, {3, 4, 2}, {3, 2, 6}, {3, 6, 8},
      {3, 8, 9}, {4, 9, 5}, {2, 4, 11}, {6, 2, 10}, {8, 6, 7}, {9, 8, 1}};
  long n = 12;
  for(int level = 1; level <= 6; ++level) {
    std::map<std::pair<long, long>, long> middles;
    std::vector<std::array<long, 3>> finer;
    for(const auto& [a, b, c] : faces) {
      const auto middle = [&](long i, long j) {
        const auto [it, is_new] = middles.try_emplace(std::minmax(i, j), n);
        n += is_new;
        return it->second;
      };
      const long x = middle(a, b), y = middle(b, c), z = middle(c, a);
      finer.insert(finer.end(), {{a, x, z}, {b, y, x}, {c, z, y}, {x, y, z}});
    }
    faces = finer;
    for(long block : {1, 4}) {
      if(level < 5 || (level == 6 && block == 4))
        continue;
      cholmod_common common;
      cholmod_l_start(&common);
      cholmod_triplet* entries = cholmod_l_allocate_triplet(
          n * block, n * block, block * block * (3 * faces.size() + n), -1, CHOLMOD_REAL, &common);
      const auto add = [&](long i, long j) {
        for(long k = 0; k < block * block; ++k) {
          const long row = i * block + k / block, column = j * block + k % block;
          static_cast<long*>(entries->i)[entries->nnz] = std::max(row, column);
          static_cast<long*>(entries->j)[entries->nnz] = std::min(row, column);
          static_cast<double*>(entries->x)[entries->nnz++] = 1;
        }
      };
      for(long i = 0; i < n; ++i)
        add(i, i);
      for(const auto& face : faces)
        for(int k = 0; k < 3; ++k)
          add(face[k], face[(k + 1) % 3]);
      cholmod_sparse* A = cholmod_l_triplet_to_sparse(entries, 0, &common);
      std::printf("%ld vertices, %ld unknowns each: ", n, block);
      cholmod_factor* L = cholmod_l_analyze(A, &common);
      const int taken = common.method[common.selected].ordering;
      std::printf("default %s", taken == CHOLMOD_METIS ? "METIS" : taken == CHOLMOD_AMD ? "AMD" : "?");
      cholmod_l_free_factor(&L, &common);
      common.nmethods = 1;
      for(int ordering : {CHOLMOD_AMD, CHOLMOD_METIS}) {
        common.method[0].ordering = ordering;
        L = cholmod_l_analyze(A, &common);
        std::printf(", %s %.0f", ordering == CHOLMOD_AMD ? "AMD" : "METIS", common.lnz / (n * block));
        cholmod_l_free_factor(&L, &common);
      }
      std::printf(" entries a row\n");
      cholmod_l_free_triplet(&entries, &common);
      cholmod_l_free_sparse(&A, &common);
      cholmod_l_finish(&common);
    }
  }
}
CPP
cat >wanted <<'TEXT'
10242 vertices, 1 unknowns each: default AMD, AMD 46, METIS 36 entries a row
10242 vertices, 4 unknowns each: default METIS, AMD 183, METIS 142 entries a row
40962 vertices, 1 unknowns each: default AMD, AMD 58, METIS 44 entries a row
TEXT

library=$work/root/usr/lib/$(gcc -dumpmachine)
export LD_LIBRARY_PATH=$library:$library/blas:$library/lapack
g++ -std=c++17 -O1 -I root/usr/include/suitesparse order.cpp -L "$library" \
  -Wl,-rpath-link,"$LD_LIBRARY_PATH" -l:libcholmod.so.3 -o order
ls -- libcholmod*.deb libmetis*.deb
./order | tee seen
diff wanted seen
