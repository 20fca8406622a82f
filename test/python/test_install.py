# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""What `cmake --install` puts below a prefix, and the Debian package, can be imported from there; what
`pip install` asks of CMake are options of this build, and the version is where it looks for it."""

import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest

import conformal_geometry as cg

BUILD = os.environ.get("CGP_BUILD_FOLDER")
PROJECT = pathlib.Path(__file__).parents[2] / "examples/python/pyproject.toml"


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


@pytest.mark.skipif(not BUILD, reason="no build folder")
def test_what_pip_asks_of_cmake():
    tomllib = pytest.importorskip("tomllib")
    asked = tomllib.loads(PROJECT.read_text(encoding="utf-8"))["tool"]["scikit-build"]
    folder = PROJECT.parent
    cached = re.findall(r"(?m)^(\w+):", pathlib.Path(BUILD, "CMakeCache.txt").read_text("utf-8"))
    assert set(asked["cmake"]["define"]) <= {*cached, "BUILD_SHARED_LIBS"}
    assert (folder / asked["cmake"]["source-dir"] / "CMakeLists.txt").exists()
    version = asked["metadata"]["version"]
    found = re.search(version["regex"], (folder / version["input"]).read_text(encoding="utf-8"))
    assert found["value"] == cg.__version__
