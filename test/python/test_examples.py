# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""The examples run; so does the add-on for Blender: in Blender where it is installed, and with as
much of Blender as it asks for."""

import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import types

import numpy as np
import pytest

import conformal_geometry as cg
from conformal_geometry.pictures import ring
from meshes import icosphere

EXAMPLES = pathlib.Path(__file__).parents[2] / "examples/python"


def test_the_first_picture(tmp_path):
    output = tmp_path / "beads.ply"
    subprocess.run([sys.executable, EXAMPLES / "first_picture.py", output], check=True,
                   stdout=subprocess.DEVNULL)
    assert output.read_text().startswith("ply\nformat ascii 1.0\nelement vertex 6480\n")


def programs_of_the_page():
    page = (EXAMPLES.parents[1] / "doc/python.md").read_text(encoding="utf-8")
    return re.findall(r"```python\n(.*?)```", page, re.DOTALL)


def test_the_program_of_the_page(tmp_path, monkeypatch):
    meshio = pytest.importorskip("meshio")
    V, F = icosphere(3)
    monkeypatch.chdir(tmp_path)
    meshio.write_points_cells("bear.off", V, [("triangle", F)])
    found = {}
    exec(programs_of_the_page()[0], found)
    written = meshio.read("bear_spin.ply")
    assert np.allclose(written.points, found["result"].positions)
    assert np.array_equal(written.cells_dict["triangle"], F)
    assert np.abs(written.points - V).max() > .1


def test_the_page_reads_corners_with_texture_coordinates_and_normals(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    pathlib.Path("mesh.obj").write_text(
        "# two\nv 0 0 0\nv 1 0 0\nv 0 1 .5\nv 1 1 0\nvt 0 0\nvt 1 0\nvn 0 0 1\n"
        "f 1/1/1 2/2/1 3/1/1\nf 3//1 2//1 4//1\n", encoding="ascii")
    found = {"np": np}
    exec(programs_of_the_page()[1], found)
    assert np.array_equal(found["V"], [[0, 0, 0], [1, 0, 0], [0, 1, .5], [1, 1, 0]])
    assert np.array_equal(found["F"], [[0, 1, 2], [2, 1, 3]])


class Polyscope_stand_in:
    """As much of polyscope as the page asks for, with the refusals of its sources."""

    def __init__(self):
        self.shown = None

    def init(self):
        self.shown = {}

    def register_surface_mesh(self, _name, vertices, faces):
        assert vertices.shape[1] == 3 and faces.ndim == 2
        self.vertices, self.faces = len(vertices), len(faces)
        return self

    def add_scalar_quantity(self, name, values, defined_on="vertices", enabled=None):
        assert values.shape == ({"vertices": self.vertices, "faces": self.faces}[defined_on],)
        self.shown[name] = enabled

    def show(self):
        assert self.shown == {"rho": True, "Q": None}


def test_polyscope_takes_what_the_page_gives_it(monkeypatch):
    window = Polyscope_stand_in()
    monkeypatch.setitem(sys.modules, "polyscope", window)
    V, F, angle = ring(40, 12)
    rho = .3 * np.sin(3 * angle)
    exec(programs_of_the_page()[2], {"cg": cg, "V": V, "F": F, "rho": rho, "result": cg.spin_transform(V, F, rho)})
    assert window.shown


def test_gradients_fit_a_target():
    spec = importlib.util.spec_from_file_location("fit", EXAMPLES / "fit_by_gradients.py")
    example = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(example)
    V, F = icosphere(2, .02)
    hidden = np.sin(2 * V[:, 1]) + .5 * V[:, 0]
    target = cg.spin_transform(V, F, hidden, on="vertices", max_scale=None).positions
    rho, energies = example.fit(V, F, target)
    assert len(energies) == 50 and energies.min() < 1e-4
    fitted = cg.spin_transform(V, F, rho, on="vertices", max_scale=None).positions
    assert np.abs(fitted - target).max() < .05 * np.abs(target - V).max()
    difference = rho - hidden
    assert np.ptp(difference) < .1 * np.ptp(hidden)


class Rows:
    """What Blender calls a collection of vertices or faces."""

    def __init__(self, rows):
        self.rows = rows

    def __len__(self):
        return len(self.rows)

    def __iter__(self):
        return iter(self.rows)

    def foreach_get(self, attribute, flat):
        flat[:] = np.ravel([getattr(row, attribute) for row in self.rows])

    def foreach_set(self, attribute, flat):
        for row, value in zip(self.rows, np.reshape(flat, (len(self), -1))):
            setattr(row, attribute, value)


def blender_object(V, F, weights):
    groups = [[types.SimpleNamespace(group=0, weight=w)] if w else [] for w in weights]
    mesh = types.SimpleNamespace(
        vertices=Rows([types.SimpleNamespace(co=v, groups=g) for v, g in zip(V, groups)]),
        polygons=Rows([types.SimpleNamespace(vertices=f) for f in F]), update=lambda: None)
    mesh.copy = lambda: mesh
    return types.SimpleNamespace(type="MESH", data=mesh,
                                 vertex_groups=types.SimpleNamespace(active_index=0))


@pytest.fixture
def addon(monkeypatch):
    bpy, bmesh = types.ModuleType("bpy"), types.ModuleType("bmesh")
    menu = types.SimpleNamespace(append=lambda draw: None, remove=lambda draw: None)
    bpy.types = types.SimpleNamespace(Operator=object, Menu=object, VIEW3D_MT_object=menu)
    bpy.data = types.SimpleNamespace(meshes=types.SimpleNamespace(remove=lambda mesh: None))
    bpy.props = types.SimpleNamespace(FloatProperty=dict, IntProperty=dict)
    bpy.utils = types.SimpleNamespace(register_class=lambda cls: None,
                                      unregister_class=lambda cls: None)
    work = types.SimpleNamespace(faces=[], from_mesh=lambda mesh: None, to_mesh=lambda mesh: None,
                                 free=lambda: None)
    bmesh.new = lambda: work
    bmesh.ops = types.SimpleNamespace(triangulate=lambda work, faces: None)
    monkeypatch.setitem(sys.modules, "bpy", bpy)
    monkeypatch.setitem(sys.modules, "bmesh", bmesh)
    spec = importlib.util.spec_from_file_location("addon", EXAMPLES / "blender_conformal_geometry.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def execute(operator, thing, **properties):
    told = []
    for name, value in properties.items():
        setattr(operator, name, value)
    operator.report = lambda kind, text: told.append(text)
    return operator.execute(types.SimpleNamespace(object=thing)), told


def test_the_addon_for_blender(addon):
    addon.register()
    V, F = icosphere(2)
    thing = blender_object(V, F, np.clip(V[:, 2], 0, 1))
    assert addon.Edit.poll(types.SimpleNamespace(object=thing))
    answer, told = execute(addon.CONFORMAL_OT_spin(), thing, amplitude=2., max_scale=2.)
    assert answer == {"FINISHED"} and "quasi-conformal" in told[0]
    moved, _ = addon.arrays(thing.data)
    assert np.abs(moved - V).max() > .05
    answer, _ = execute(addon.CONFORMAL_OT_flow(), thing, steps=2)
    assert answer == {"FINISHED"}
    addon.unregister()


def test_the_addon_tells_what_is_wrong(addon):
    V, F = icosphere(1)
    thing = blender_object(np.vstack([V, [9, 9, 9]]), F, np.zeros(len(V) + 1))
    answer, told = execute(addon.CONFORMAL_OT_flow(), thing, steps=2)
    assert answer == {"CANCELLED"} and "vertex 42" in told[0]


@pytest.mark.skipif(not shutil.which("blender"), reason="no Blender")
def test_the_addon_in_blender():
    """Debian's Blender, whose Python is that of the system."""
    environment = {**os.environ, "PYTHONPATH": str(pathlib.Path(cg.__file__).parents[1])}
    told = subprocess.run(
        ["blender", "--background", "--factory-startup", "--python-use-system-env",
         "--python-exit-code", "1", "--python", pathlib.Path(__file__).with_name("in_blender.py"),
         "--", EXAMPLES / "blender_conformal_geometry.py"],
        env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    assert told.returncode == 0 and "the add-on works" in told.stdout, told.stdout
