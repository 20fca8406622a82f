// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

/// \page triangle_mesh_requirements Requirements on meshes
///
/// \section triangle_mesh_type The type
/// `TriangleMesh` is a triangulated surface mesh, a model of the \cgal concepts `FaceListGraph` and
/// `HalfedgeListGraph`. Of these the library uses
/// - `boost::graph_traits<TriangleMesh>` with its `vertex_descriptor`, `halfedge_descriptor` and
///   `face_descriptor`, of which the first can be hashed by `std::hash` unless the type has
///   dynamic property maps of its own, and in `conformal_fairing()` the last as well;
/// - `vertices(mesh)`, `faces(mesh)`, `halfedge(face, mesh)`, `next(halfedge, mesh)`,
///   `source(halfedge, mesh)`, `target(halfedge, mesh)`, and in `harmonic_basis()` also
///   `opposite(halfedge, mesh)`, found by argument-dependent look-up;
/// - a vertex point map: the mesh's own, or the named parameter `vertex_point_map`, whose points
///   `geom_traits` understands, a model of `ConformalGeometryTraits_3`.
///
/// The mesh is walked once, into arrays. Its vertices and faces are numbered from 0 in the order of
/// `vertices(mesh)` and `faces(mesh)`; messages speak of these numbers. Removed elements that are
/// not yet collected do no harm, and neither index maps nor `num_vertices()` are used.
///
/// Tested with `Surface_mesh`, `Polyhedron_3` (with and without ids),
/// `Linear_cell_complex_for_combinatorial_map`, OpenMesh's `TriMesh_ArrayKernelT`, and
/// `Face_filtered_graph`, which is the way to transform a part of a mesh. The point map of
/// OpenMesh in \cgal 5.5 rounds to `float` what is written, even in meshes of `double`.
///
/// \section triangle_mesh_data The data
/// Before anything is computed it is checked that
/// - every face is a triangle with three different vertices;
/// - no edge has more than two faces, and two faces along an edge are oriented alike;
/// - the faces around a vertex form one fan, and every vertex has a face;
/// - the mesh is connected;
/// - coordinates are finite;
/// - no face has area zero relative to its longest edge.
///
/// Outward means counter-clockwise seen from outside. Functions that need a closed surface or a
/// disk say so. A mesh that breaks a rule is refused by a
/// `Conformal_geometry_processing::Precondition_error` that names the rule, how many elements break
/// it, and the first of them.
