# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The notebook runs, computes what it says, and is what its page in the manual shows."""

import importlib.util
import json
import os
import pathlib
import shutil
import subprocess
import sys

import numpy as np
import pytest

import conformal_geometry as cg
from conformal_geometry import pictures

ROOT = pathlib.Path(__file__).parents[2]
NOTEBOOK = ROOT / "examples/python/notebook.ipynb"


def installed(*modules):
    return all(importlib.util.find_spec(module) for module in modules)


def sources(*kinds):
    cells = json.loads(NOTEBOOK.read_text(encoding="utf-8"))["cells"]
    return ["".join(cell["source"]) for cell in cells if cell["cell_type"] in kinds]


def test_the_page_shows_every_cell_in_order():
    page, begin = (ROOT / "doc/notebook.md").read_text(encoding="utf-8"), 0
    for source in sources("code", "markdown"):
        assert source in page[begin:], "draw it anew: doc/draw_python notebook"
        begin = page.index(source, begin) + len(source)


@pytest.mark.skipif(not installed("matplotlib"), reason="no matplotlib")
def test_the_notebook_computes_what_it_says(monkeypatch, capsys):
    monkeypatch.setenv("MPLBACKEND", "Agg")
    monkeypatch.setattr(pictures, "picture", lambda *surfaces, **view: None)
    found = {}
    for source in sources("code"):
        exec(source, found)
    assert all(found[name] for name in ("beads", "bounded", "smooth", "pulled", "flat"))
    scales = found["bounded"].report.scales
    assert 1 / 1.5 < scales.low and scales.high < 1.5
    assert found["free"].report.conformality.scale.min_scale < .5
    assert np.all(np.diff(found["energies"]) < 0) and found["energies"][-1] > 2 * np.pi**2
    moved = found["pulled"].positions
    assert all(np.allclose(moved[v], to, atol=1e-4) for v, to in found["targets"].items())
    assert np.allclose(np.diff(np.log10(found["errors"])), -1, atol=.05)
    assert "('edge', (0, 24))" in capsys.readouterr().out


@pytest.mark.skipif(not installed("matplotlib", "nbconvert", "ipykernel"), reason="no nbconvert")
def test_nbconvert_runs_the_notebook_in_any_folder(tmp_path):
    notebook = shutil.copy(NOTEBOOK, tmp_path)
    # A history of its own: that of the user may be locked by another kernel.
    environment = {**os.environ, "PYTHONPATH": str(pathlib.Path(cg.__file__).parents[1]),
                   "IPYTHONDIR": str(tmp_path / "ipython")}
    subprocess.run([sys.executable, "-m", "nbconvert", "--to", "notebook", "--execute",
                    "--inplace", notebook], check=True, env=environment, cwd=tmp_path,
                   stderr=subprocess.DEVNULL)
    cells = json.loads((tmp_path / NOTEBOOK.name).read_text(encoding="utf-8"))["cells"]
    outputs = [output for cell in cells for output in cell.get("outputs", [])]
    assert not [output for output in outputs if output["output_type"] == "error"]
    assert sum("image/png" in output.get("data", {}) for output in outputs) == 6
