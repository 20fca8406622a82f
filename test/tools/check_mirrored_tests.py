#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Every header has the test of its own path, and every test names a file that exists.

include/Conformal_geometry_processing/mesh/Mesh_view.h is tested by test/mesh/mesh_view.cpp (letter case
is free), include/Quaternionic_linear_algebra/X.h by test/quaternionic_linear_algebra/X.cpp, or by a test
whose head says so: `// Tests mesh/Mesh_view.h`.
"""

import re

import sources

UNTESTED = {"config.h", "exceptions.h", "version.h"}  # nothing that computes
CLAIM = re.compile(r"^// Tests\s+(.*)", re.MULTILINE)


def tests():
    outside = ("tools", "downstream", "compile_fail", "support")
    return [path for path in sources.files(".cpp")
            if path.parts[0] == "test" and path.parts[1] not in outside]


def claims(test):
    """The files named on the `// Tests` lines in the first ten lines, as paths below the root or,
    for short, below the folder of a library."""
    head = "\n".join((sources.ROOT / test).read_text(encoding="utf-8").splitlines()[:10])
    return [name for claim in CLAIM.findall(head)
            for name in re.findall(r"[\w./+-]+\.(?:h|cpp)\b", claim)]


def complaints():
    mirrored = {test.relative_to("test").with_suffix("").as_posix().lower() for test in tests()}
    claimed = {name for test in tests() for name in claims(test)}
    for header in sources.headers():
        short = header.relative_to(header.parts[0])
        wanted = (short if header.parts[0] == sources.LIBRARY else header).with_suffix("")
        if (header.name not in UNTESTED and not claimed & {f"include/{header}", short.as_posix()}
                and wanted.as_posix().lower() not in mirrored):
            yield f"include/{header}: has no test/{wanted}.cpp"
    for test in tests():
        for name in claims(test):
            if not any((base / name).exists() for base in (sources.ROOT, *sources.HOUSES)):
                yield f"{test}: says it tests {name}, which does not exist"


if __name__ == "__main__":
    sources.finish(list(complaints()), f"the tests of {len(sources.headers())} headers")
