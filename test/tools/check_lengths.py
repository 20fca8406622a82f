#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""One idea per file: no file of code is longer than 400 lines."""

import sources

LONGEST = 400


def complaints():
    for path in sources.files(".h", ".cpp", ".py", ".pyi"):
        lines = len((sources.ROOT / path).read_text(encoding="utf-8").splitlines())
        if lines > LONGEST:
            yield f"{path}: {lines} lines, more than {LONGEST}"


if __name__ == "__main__":
    sources.finish(list(complaints()), "lengths")
