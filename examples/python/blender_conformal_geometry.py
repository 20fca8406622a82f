# Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
"""An add-on for Blender: in Object mode, the menu Object > Conformal geometry.

Install it by Edit > Preferences > Add-ons > Install; Blender's Python needs the module
conformal_geometry, NumPy and SciPy (Debian's Blender uses the system's Python). Faces are
triangulated, so that their number may change; undo takes all of it back.
"""

import bmesh
import bpy
import numpy as np

import conformal_geometry as cg

bl_info = {
    "name": "Conformal geometry",
    "description": "Edits and smooths surfaces by their curvature, without shear",
    "author": "The Conformal Geometry Processing authors",
    "blender": (2, 93, 0),
    "location": "Object > Conformal geometry",
    "category": "Mesh",
}


def triangulate(mesh):
    work = bmesh.new()
    work.from_mesh(mesh)
    bmesh.ops.triangulate(work, faces=work.faces[:])
    work.to_mesh(mesh)
    work.free()


def arrays(mesh):
    """V and F of a mesh of triangles."""
    V, F = np.empty(3 * len(mesh.vertices)), np.empty(3 * len(mesh.polygons), dtype=np.int32)
    mesh.vertices.foreach_get("co", V)
    mesh.polygons.foreach_get("vertices", F)
    return V.reshape(-1, 3), F.reshape(-1, 3)


def weights(mesh, group):
    """Of each vertex in the group with this index; 0 outside of it."""
    return np.array([next((g.weight for g in v.groups if g.group == group), 0.)
                     for v in mesh.vertices])


def write(mesh, V):
    mesh.vertices.foreach_set("co", V.ravel())
    mesh.update()


class Edit:
    """What the operators have in common: arrays out, arrays in, faults to the status bar."""

    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.type == "MESH"

    def refuse(self, reason):
        self.report({"ERROR"}, reason)
        return {"CANCELLED"}

    def execute(self, context):
        mesh = context.object.data
        triangles = mesh.copy()  # for the mesh changes only if all is well
        try:
            triangulate(triangles)
            result = self.compute(context.object, *arrays(triangles))
        except cg.Error as error:
            return self.refuse(str(error))
        finally:
            bpy.data.meshes.remove(triangles)
        if not result:
            return self.refuse(result.report.fault)
        triangulate(mesh)
        write(mesh, result.positions)
        Q = result.report.conformality.quasi_conformal.mean
        self.report({"INFO"}, f"mean quasi-conformal error {Q:.3f}, 1 is conformal")
        return {"FINISHED"}


class CONFORMAL_OT_spin(Edit, bpy.types.Operator):
    """Changes the mean curvature by the weights of the active vertex group"""
    bl_idname = "conformal.spin"
    bl_label = "Spin by vertex group"

    amplitude: bpy.props.FloatProperty(
        name="Amplitude", default=2,
        description="change of curvature where the weight is 1, relative to a ball of this size")
    max_scale: bpy.props.FloatProperty(
        name="Largest scale", default=cg.default_max_scale, min=1.01,
        description="lengths change by this factor at most")

    def compute(self, thing, V, F):
        radius = np.linalg.norm(np.ptp(V, axis=0)) / 2
        rho = self.amplitude / radius * weights(thing.data, thing.vertex_groups.active_index)
        return cg.spin_transform(V, F, rho, on="vertices", max_scale=self.max_scale)


class CONFORMAL_OT_flow(Edit, bpy.types.Operator):
    """Makes the surface as smooth as its conformal class allows"""
    bl_idname = "conformal.flow"
    bl_label = "Willmore flow"

    steps: bpy.props.IntProperty(name="Steps", default=5, min=1)

    def compute(self, thing, V, F):
        return cg.willmore_flow(V, F, max_steps=self.steps)


class CONFORMAL_MT_menu(bpy.types.Menu):
    bl_label = "Conformal geometry"

    def draw(self, context):
        self.layout.operator(CONFORMAL_OT_spin.bl_idname)
        self.layout.operator(CONFORMAL_OT_flow.bl_idname)


CLASSES = (CONFORMAL_OT_spin, CONFORMAL_OT_flow, CONFORMAL_MT_menu)


def in_menu(menu, context):
    menu.layout.menu(CONFORMAL_MT_menu.__name__)


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.VIEW3D_MT_object.append(in_menu)


def unregister():
    bpy.types.VIEW3D_MT_object.remove(in_menu)
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)


if __name__ == "__main__":
    register()
