# Copyright (c) 2026 The Conformal Geometry Processing authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What `cmake --install` puts below a prefix, and the Debian package, can be imported from there."""

import os
import shutil
import subprocess
import sys

import pytest

BUILD = os.environ.get("CGP_BUILD_FOLDER")


def imported_from(folder, working_directory):
    """Where a Python that looks into this folder finds the module."""
    environment = {**os.environ, "PYTHONPATH": str(folder)}
    code = "import conformal_geometry as cg; print(cg.__file__, cg.__version__)"
    return subprocess.run([sys.executable, "-c", code], check=True, env=environment,
                          cwd=working_directory, stdout=subprocess.PIPE, text=True).stdout


@pytest.mark.skipif(not BUILD, reason="no build folder")
def test_the_installed_module(tmp_path):
    for component in ("libraries", "python"):
        subprocess.run(["cmake", "--install", BUILD, "--component", component,
                        "--prefix", tmp_path], check=True, stdout=subprocess.DEVNULL)
    package, = tmp_path.rglob("conformal_geometry/__init__.py")
    assert imported_from(package.parents[1], tmp_path).startswith(str(package))


@pytest.mark.skipif(not BUILD or not shutil.which("dpkg-deb"), reason="no build folder, or no Debian")
def test_the_packaged_module(tmp_path):
    subprocess.run(["cpack", "-G", "DEB", "--config", f"{BUILD}/CPackConfig.cmake", "-D",
                    "CPACK_COMPONENTS_ALL=libraries;python_debian"],
                   check=True, cwd=tmp_path, stdout=subprocess.DEVNULL)
    packages = list(tmp_path.glob("*.deb"))
    assert len(packages) == 2
    for package in packages:
        subprocess.run(["dpkg-deb", "--extract", package, tmp_path / "root"], check=True)
    folder = tmp_path / "root/usr/lib/python3/dist-packages"
    assert imported_from(folder, tmp_path).startswith(str(folder))
