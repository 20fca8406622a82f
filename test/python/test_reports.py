# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The reports have all fields of those of the library; the stubs say what the module has."""

import ast
import dataclasses
import inspect
import pathlib
import pickle
import re

import numpy as np
import pytest

import conformal_geometry as cg
from conformal_geometry import _kernels
from meshes import icosphere

INCLUDE = pathlib.Path(__file__).parents[2] / "include/Conformal_geometry_processing"
V, F = icosphere(2)


def members(header, struct):
    """The names of the data members of a struct, without those of inner structs."""
    text = re.sub(r"//.*", "", (INCLUDE / header).read_text(encoding="utf-8"))
    text = text[re.search(rf"struct (?:\[\[nodiscard\]\] )?{struct}\b[^{{;]*{{", text).end():]
    depth, body = 1, ""
    for character in text:  # what is outside of inner braces
        depth += (character == "{") - (character == "}")
        if depth == 0:
            break
        body += character if depth == 1 else ""
    body = body.replace("}", " ")
    names = set()
    for statement in body.split(";"):
        words = statement.split()
        is_type = words[:1] in (["enum"], ["static"]) or words[:1] == ["struct"] and len(words) == 2
        if words and not is_type and "(" not in statement:
            names |= {part.split("=")[0].split()[-1] for part in statement.split(",")}
    return names


@pytest.mark.parametrize("header, struct, report", [
    ("spin/Spin_report.h", "Spin_report", cg.Spin_report),
    ("spin/Dirac_solution.h", "Dirac_evidence", cg.Spin_report),
    ("spin/Spin_report.h", "Mollification", cg.Mollification),
    ("spin/Spin_report.h", "Scales", cg.Scales),
    ("flow/Flow_report.h", "Flow_step_report", cg.Flow_step_report),
    ("flow/Flow_report.h", "Flow_report", cg.Flow_report),
    ("flow/Flow_report.h", "Place", cg.Place),
    ("measure/Conformality.h", "Conformality", cg.Conformality),
    ("parameterization/spectral_parameterization.h", "Parameterization_report",
     cg.Parameterization_report),
    ("measure/Realised_curvature.h", "Realised_curvature", cg.Realised_curvature),
    ("spin/Spin_report.h", "Class_snap_report", cg.Class_snap_report),
])
def test_reports_have_all_fields(header, struct, report):
    wanted = members(header, struct)
    assert len(wanted) >= 3
    assert wanted - {field.name for field in dataclasses.fields(report)} == set()


def test_reports_tell():
    result = cg.spin_transform(V, F, np.sin(3 * V[:, 1]))
    report = result.report
    assert bool(report) and bool(result)
    assert "verified" in result._repr_html_() and "closure_residual" in report._repr_html_()
    assert "conformality.quasi_conformal.mean" in str(report)
    assert pickle.loads(pickle.dumps(report)) == report
    assert dataclasses.asdict(report)["seconds"]["setup"] >= 0
    with pytest.raises(dataclasses.FrozenInstanceError):
        report.converged = False


def test_limits_decide():
    strict = cg.spin_transform(V, F, np.sin(3 * V[:, 1]), limits=dict(quasi_conformal=1.0001))
    assert not strict and strict.report.limits.quasi_conformal == 1.0001
    assert strict.report.fault.endswith("the map is not conformal")
    assert strict.report.fault in strict._repr_html_()
    assert len(strict.positions) == len(V)


def parameters_of_binding(function):
    """From the first line of a docstring of pybind11."""
    line = function.__doc__.splitlines()[0]
    return re.findall(r"(\w+):", line[line.index("(") + 1:line.rindex(")")])


def test_the_stub_is_that_of_the_module():
    stub = ast.parse((pathlib.Path(cg.__file__).parent / "_kernels.pyi").read_text())
    functions = {node.name: node for node in stub.body if isinstance(node, ast.FunctionDef)}
    classes = {node.name: node for node in stub.body if isinstance(node, ast.ClassDef)}
    numbers = {node.target.id for node in stub.body if isinstance(node, ast.AnnAssign)}
    public = {name for name in vars(_kernels) if not name.startswith("_")} | {"__version__"}
    assert public == functions.keys() | classes.keys() | numbers
    for name, node in functions.items():
        assert [a.arg for a in node.args.args] == parameters_of_binding(getattr(_kernels, name))
    for name, node in classes.items():
        for method in (n for n in node.body if isinstance(n, ast.FunctionDef)):
            own = getattr(getattr(_kernels, name), method.name)
            assert [a.arg for a in method.args.args] == parameters_of_binding(own)


def test_everything_public_is_documented_and_annotated():
    for name in cg.__all__:
        thing = getattr(cg, name)
        if name.startswith("__"):
            continue
        assert inspect.getdoc(thing), name
        if inspect.isfunction(thing):
            signature = inspect.signature(thing)
            assert signature.return_annotation is not inspect.Signature.empty, name
            for parameter in signature.parameters.values():
                assert parameter.annotation is not inspect.Parameter.empty, (name, parameter)
