# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""What was measured for a page: lines of JSON in doc/data/NAME.jsonl.gz. The same rows always are the
same bytes."""

import gzip
import json

from page import machine

FOLDER = machine.ROOT / "doc" / "data"


def path(name):
    return FOLDER / f"{name}.jsonl.gz"


def load(name):
    """The rows, none where nothing has been measured yet."""
    if not path(name).exists():
        return []
    return [json.loads(line) for line in gzip.decompress(path(name).read_bytes()).splitlines()]


def save(name, rows):
    text = "".join(json.dumps(row) + "\n" for row in rows)
    path(name).write_bytes(gzip.compress(text.encode(), mtime=0))
