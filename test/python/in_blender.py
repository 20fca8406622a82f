# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""What test_blender.py runs inside of Blender: blender --background --python in_blender.py -- ADDON

Both operators of the add-on, called as its menu does, do to a ball with a vertex group what the
module does to its arrays, in Blender's single precision; what is unsuitable is an error and changes
nothing.
"""

import runpy
import sys

import bpy
import numpy as np

import conformal_geometry as cg

addon = runpy.run_path(sys.argv[sys.argv.index("--") + 1], run_name="addon")
addon["register"]()


def ball():
    """An active object whose vertices weigh their height in a vertex group."""
    bpy.ops.mesh.primitive_ico_sphere_add(subdivisions=4)
    thing = bpy.context.object
    group = thing.vertex_groups.new(name="height")
    for vertex in thing.data.vertices:
        group.add([vertex.index], max(vertex.co.z, 0.), "REPLACE")
    return thing


thing = ball()
V, F = addon["arrays"](thing.data)
heights = addon["weights"](thing.data, 0)
assert np.allclose(heights, np.clip(V[:, 2], 0, 1), atol=1e-6)

assert bpy.ops.conformal.spin(amplitude=3., max_scale=2.) == {"FINISHED"}
spun, _ = addon["arrays"](thing.data)
rho = 3 * heights / (np.linalg.norm(np.ptp(V, axis=0)) / 2)
expected = cg.spin_transform(V, F, rho, on="vertices", max_scale=2.).positions
assert np.abs(expected - V).max() > .1
assert np.allclose(spun, expected, atol=1e-5)

assert bpy.ops.conformal.flow(steps=2) == {"FINISHED"}
smooth, _ = addon["arrays"](thing.data)
assert np.allclose(smooth, cg.willmore_flow(spun, F, max_steps=2).positions, atol=1e-5)

bpy.ops.mesh.primitive_cube_add()
cube = bpy.context.object.data
cube.vertices.add(1)  # of no face
try:
    bpy.ops.conformal.flow(steps=1)
except RuntimeError as error:  # how Blender tells its scripts what operators report
    assert "vertex 8" in str(error), error
else:
    raise AssertionError("an unsuitable mesh was accepted")
assert len(cube.polygons) == 6 and len(bpy.data.meshes) == 3  # its own, the ball's, the cube's

assert hasattr(bpy.types, "CONFORMAL_MT_menu")
addon["unregister"]()
assert not hasattr(bpy.types, "CONFORMAL_MT_menu")
print("the add-on works")
