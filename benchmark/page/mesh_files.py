# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The mesh files below a folder: each content once, compressed ones (.gz) unpacked elsewhere."""

import collections
import gzip
import hashlib

ENDINGS = {".off", ".obj", ".ply", ".stl"}


def is_mesh(path):
    name = path.with_suffix("") if path.suffix == ".gz" else path
    return path.is_file() and name.suffix.lower() in ENDINGS


def unpacked(path, content, work):
    """A file with the content: the path itself, or a new one in the folder work."""
    if path.suffix != ".gz":
        return path
    target = work / hashlib.sha256(content).hexdigest()[:16] / path.stem
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_bytes(content)
    return target


def below(folder, work):
    """{name: file}. The name is that of the file, or its path where names are not unique."""
    found = {}
    for path in sorted(filter(is_mesh, folder.rglob("*"))):
        data = path.read_bytes()
        content = gzip.decompress(data) if path.suffix == ".gz" else data
        digest = hashlib.sha256(content).digest()
        if digest not in found:
            found[digest] = (path, unpacked(path, content, work))
    times = collections.Counter(path.name for path, _ in found.values())
    return {path.name if times[path.name] == 1 else str(path.relative_to(folder)): file
            for path, file in found.values()}
