# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The meshes that CGAL comes with: on Debian in the package libcgal-demo."""

import pathlib
import tarfile


def unpack(folder):
    """The folder of the meshes, unpacked there unless they are already."""
    meshes = folder / "meshes"
    if not meshes.exists():
        archives = sorted(pathlib.Path("/usr/share/doc").glob("libcgal-*/data.tar.gz"))
        if not archives:
            raise SystemExit("no meshes; apt-get install libcgal-demo, or pass --data FOLDER")
        meshes.mkdir(parents=True)
        with tarfile.open(archives[0]) as archive:
            for member in archive.getmembers():
                if member.isfile() and member.name.startswith("data/meshes/"):
                    target = meshes / pathlib.PurePath(member.name).name
                    target.write_bytes(archive.extractfile(member).read())
    return meshes
