# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The types of the module tell the shapes of arrays, and results have them."""

import dataclasses
import importlib.util
import inspect
import os
import pathlib
import subprocess
import sys
import typing

import numpy as np
import pytest

import conformal_geometry as cg
from meshes import icosphere

# What shapes are called in the types: V vertices, F faces, k forms or eigenvalues.
USES = """
import numpy as np
import conformal_geometry as cg
V = np.zeros((4, 3))
F = [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 2]]
result = cg.spin_transform(V, F, [0., 1., 2., 3.], max_scale=None)
rows: int = result.positions.shape[0]
three: int = result.positions.shape[1]
cg.deform(V, F, {0: (1., 2., 3.)}).rho.shape[0]
"""
WRONG = USES + "columns = result.positions.shape[2]\ncg.spin_transform(V, F, rho=object())\n"


def functions():
    """(name, function) of all that users call, methods too."""
    for name in cg.__all__:
        value = getattr(cg, name)
        if inspect.isfunction(value):
            yield name, value
        elif inspect.isclass(value):
            written = [method for method in vars(value) if method[0] != "_"]
            if not dataclasses.is_dataclass(value):  # whose fields are checked as those of results
                written.append("__init__")
            yield from ((f"{name}.{method}", vars(value)[method]) for method in written
                        if inspect.isfunction(vars(value).get(method)))


def test_arguments_have_shapes():
    named = {"V": "n x 3", "F": "m x 3 integers", "rho": "n or m", "vertex_scale": "n", "vertex_region": "n"}
    seen = set()
    for name, function in functions():
        hints = typing.get_type_hints(function, include_extras=True)
        for parameter in inspect.signature(function).parameters:
            assert hints.get(parameter) is not typing.Any, f"{name}: {parameter} may be anything"
            if parameter in named:
                seen.add(parameter)
                assert named[parameter] in str(hints[parameter]), f"{name}: {parameter} is {hints[parameter]}"
    assert seen == set(named)


def shape_of(hint):
    """The lengths of a type of arrays, None where any will do; None for other types."""
    if typing.get_origin(hint) is not np.ndarray or not typing.get_args(hint):
        return None
    lengths, _ = typing.get_args(hint)
    return [typing.get_args(length)[0] if typing.get_origin(length) is typing.Literal else None
            for length in typing.get_args(lengths)]


def results():
    V, F = icosphere(2)
    rho = np.sin(3 * V[:, 1])
    disk = F[V[F].mean(axis=1)[:, 2] > 0]
    kept, disk = np.unique(disk, return_inverse=True)
    return [cg.spin_transform(V, F, rho), cg.deform(V, F, {0: V[0] * 1.05, 40: V[40], 80: V[80], 120: V[120]}),
            cg.willmore_flow(V * [1.3, 1, 1], F, max_steps=1), cg.flatten(V[kept], disk.reshape(-1, 3)),
            cg.harmonic_basis(V, F), cg.dirac_spectrum(V, F, 3), cg.snap_to_conformal_class(V, V, F),
            cg.make_delaunay(V * [4, 1, 1], F)]


@pytest.mark.parametrize("result", results(), ids=lambda result: type(result).__name__)
def test_results_have_the_shapes_of_their_types(result):
    arrays = 0
    hints = typing.get_type_hints(type(result))
    for field in dataclasses.fields(result):
        wanted, value = shape_of(hints[field.name]), getattr(result, field.name)
        assert isinstance(value, np.ndarray) == (wanted is not None), f"{field.name} is a {type(value)}"
        if wanted is not None:
            arrays += 1
            assert len(value.shape) == len(wanted), f"{field.name}: {value.shape}, not {wanted}"
            assert all(w in (None, n) for w, n in zip(wanted, value.shape)), f"{field.name}: {value.shape}"
            assert value.dtype == typing.get_args(typing.get_args(hints[field.name])[1])[0]
    assert arrays > 0


def checked(folder, *what):
    """What mypy says, and whether it agrees."""
    package = pathlib.Path(cg.__file__).parent
    found = subprocess.run([sys.executable, "-m", "mypy", *what], cwd=folder, capture_output=True, text=True,
                           env={**os.environ, "MYPYPATH": str(package.parent)})
    return found.returncode == 0, found.stdout + found.stderr


needs_mypy = pytest.mark.skipif(importlib.util.find_spec("mypy") is None, reason="Debian: apt-get install mypy")


@needs_mypy
@pytest.mark.parametrize("program, is_right", [(USES, True), (WRONG, False)], ids=["right", "wrong"])
def test_a_checker_of_types_agrees(tmp_path, program, is_right):
    (tmp_path / "uses.py").write_text(program)
    agrees, words = checked(tmp_path, "--strict", "--follow-imports=silent", "uses.py")
    assert agrees == is_right, words


@needs_mypy
def test_the_module_keeps_to_its_types(tmp_path):
    agrees, words = checked(tmp_path, "--ignore-missing-imports", str(pathlib.Path(cg.__file__).parent))
    assert agrees, words
