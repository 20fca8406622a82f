# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""Python and the program compute the same, up to the order of sums.

Python takes vertices as the arrays have them, the program along a curve through their positions."""

import json
import os
import subprocess

import numpy as np
import pytest

import conformal_geometry as cg
from meshes import icosphere, patch, torus, write_ply

PROGRAM = os.environ.get("CGP_CONFORMAL_PROGRAM")
pytestmark = pytest.mark.skipif(not PROGRAM, reason="the program was not built")


def in_a_box(V):
    """In a box of 1 x 2 x 2, whose half diagonal, the program's unit of length, is 1.5 exactly."""
    low, high = V.min(axis=0), V.max(axis=0)
    return (V - low) / (high - low) * [1., 2, 2]


def read_vertices(path):
    """The numbers of the vertices of a PLY file, by name."""
    data = path.read_bytes()
    head, _, body = data.partition(b"end_header\n")
    lines = head.decode().split("element face")[0].splitlines()
    count = next(int(line.split()[2]) for line in lines if line.startswith("element vertex"))
    kinds = {"double": "<f8", "float": "<f4"}
    fields = [(line.split()[2], kinds[line.split()[1]]) for line in lines
              if line.startswith("property")]
    return np.frombuffer(body, dtype=fields, count=count)


def run(*arguments):
    subprocess.run([PROGRAM, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


def agree(a, b):
    return a.shape == b.shape and np.abs(a - b).max() < 1e-8


def positions(vertices):
    return np.column_stack([vertices[c] for c in "xyz"])


@pytest.mark.parametrize("mesh", [icosphere(2, .05), torus(18, 9), patch(8, .2)])
@pytest.mark.parametrize("max_scale", [None, 1.2, cg.default_max_scale])
def test_spin(mesh, max_scale, tmp_path):
    V, F = in_a_box(mesh[0]), mesh[1]
    rho = np.sin(4 * V[:, 1]) + .3 * V[:, 0]
    write_ply(tmp_path / "in.ply", V, F, rho=rho)
    bound = [] if max_scale is cg.default_max_scale else ["--max-scale", max_scale or "none"]
    run("spin", tmp_path / "in.ply", "--rho-property", "rho", *bound, "--lambda", "q",
        "-o", tmp_path / "out.ply")
    result = cg.spin_transform(V, F, (1 / 1.5) * rho, on="vertices", max_scale=max_scale)
    assert result
    vertices = read_vertices(tmp_path / "out.ply")
    assert agree(positions(vertices), result.positions)
    assert agree(np.column_stack([vertices["q_" + c] for c in "wxyz"]), result.spins)


def test_flow(tmp_path):
    V, F = in_a_box(icosphere(2, .05)[0]), icosphere(2)[1]
    write_ply(tmp_path / "in.ply", V, F)
    run("flow", tmp_path / "in.ply", "--steps", "3", "-o", tmp_path / "out.ply")
    result = cg.willmore_flow(V, F, max_steps=3)
    assert agree(positions(read_vertices(tmp_path / "out.ply")), result.positions)


@pytest.mark.parametrize("mesh", [icosphere(2, .05), torus(18, 9), patch(8, .2)])
def test_deform(mesh, tmp_path):
    V, F = in_a_box(mesh[0]), mesh[1]
    vertices = range(0, len(V), len(V) // 6)
    targets = {v: V[v] for v in vertices}
    targets[vertices[2]] = V[vertices[2]] + [.1, .05, -.1]
    write_ply(tmp_path / "in.ply", V, F)
    (tmp_path / "targets.json").write_text(json.dumps(
        {"targets": [{"vertex": v, "to": list(p)} for v, p in targets.items()]}))
    run("deform", tmp_path / "in.ply", "--targets", tmp_path / "targets.json", "--lambda", "q",
        "-o", tmp_path / "out.ply")
    result = cg.deform(V, F, targets)
    assert result
    found = read_vertices(tmp_path / "out.ply")
    assert agree(positions(found), result.positions)
    assert agree(np.column_stack([found["q_" + c] for c in "wxyz"]), result.spins)
