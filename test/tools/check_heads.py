#!/usr/bin/env python3
# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Every file states its copyright and licence in one of its first lines, and every header has
`#pragma once` below that."""

import re

import sources

LINE = "Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later"


def complaints():
    for path in sources.files(".h", ".cpp", ".py", ".pyi", ".sh"):
        before, line, text = (sources.ROOT / path).read_text(encoding="utf-8").partition(LINE + "\n")
        if not line or before.count("\n") > 3:
            yield f"{path}: no line \"{LINE}\" at the top"
        elif path.suffix == ".h" and path.parts[0] != "doc" and not re.match(r"(//.*\n)*#pragma once\n", text):
            yield f"{path}: no #pragma once below its licence"


if __name__ == "__main__":
    sources.finish(list(complaints()), "licences and guards")
