# Copyright (c) 2026 The Conformal Geometry Processing authors
# SPDX-License-Identifier: LGPL-3.0-or-later
"""What `cmake --install` puts below a prefix can be imported from there."""

import os
import subprocess
import sys

import pytest

BUILD = os.environ.get("CGP_BUILD_FOLDER")


@pytest.mark.skipif(not BUILD, reason="no build folder")
def test_the_installed_module(tmp_path):
    for component in ("libraries", "python"):
        subprocess.run(["cmake", "--install", BUILD, "--component", component,
                        "--prefix", tmp_path], check=True, stdout=subprocess.DEVNULL)
    package, = tmp_path.rglob("conformal_geometry/__init__.py")
    environment = {**os.environ, "PYTHONPATH": str(package.parents[1])}
    code = "import conformal_geometry as cg; print(cg.__file__, cg.__version__)"
    told = subprocess.run([sys.executable, "-c", code], check=True, env=environment, cwd=tmp_path,
                          stdout=subprocess.PIPE, text=True).stdout
    assert told.startswith(str(package))
