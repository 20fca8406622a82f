// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

using namespace Conformal_geometry_processing;

/// \ingroup PkgConcepts
/// \cgalConcept
///
/// \brief supplies the property maps of the curvature potential rho, the spin lambda and the
/// normals of a mesh.
///
/// A pipeline that keeps its data in the mesh, or beside it, needs no map of its own:
/// \code
/// CGP::Conformal_mesh_traits<Mesh> traits(mesh);
/// CGP::compute_vertex_normals(mesh, traits.vertex_normal_map());
/// for (auto v : vertices(mesh)) put(traits.vertex_curvature_potential_map(), v, rho_at(v));
/// CGP::spin_transform(mesh, traits.vertex_curvature_potential_map(),
///                     CGP::parameters::vertex_spin_map(traits.vertex_spin_map()));
/// \endcode
/// The entry points take any other map just as well. To bring your own storage, specialise
/// `Conformal_mesh_traits` for your mesh type.
///
/// Each map is a model of `ReadWritePropertyMap`, may be used longer than the traits, but not
/// longer than the mesh, and shares its values with its copies.
///
/// Headers of these types:
/// - `Conformal_geometry_processing::Conformal_mesh_traits`,
///   `Conformal_geometry_processing/core/Conformal_mesh_traits.h`
/// - `Conformal_geometry_processing::Quaternion`,
///   `Quaternionic_linear_algebra/algebra/Quaternion.h`
///
/// \cgalHasModelsBegin
/// \cgalHasModels{`Conformal_geometry_processing::Conformal_mesh_traits<TriangleMesh>`: dynamic
/// property maps on any mesh;}
/// \cgalHasModels{the specialisation for `CGAL::Surface_mesh`: persistent properties `v:rho`,
/// `f:rho`, `v:lambda`, `v:normal`;}
/// \cgalHasModels{the specialisation for `CGAL::Polyhedron_3`: containers beside the mesh.}
/// \cgalHasModelsEnd
class ConformalMeshTraits {
 public:
  /// \name Types
  /// @{

  /// the mesh, see \ref triangle_mesh_requirements
  typedef unspecified_type Triangle_mesh;

  /// from vertices to `double`: rho in 1/length, initially 0
  typedef unspecified_type Vertex_curvature_potential_map;

  /// from faces to `double`: rho in 1/length, initially 0
  typedef unspecified_type Face_curvature_potential_map;

  /// from vertices to `Quaternion<double>`: lambda, initially 1
  typedef unspecified_type Vertex_spin_map;

  /// from vertices to a vector with `x()`, `y()`, `z()`, which is constructed from three
  /// numbers: initially 0. The kernel's `Vector_3` in the models here
  typedef unspecified_type Vertex_normal_map;

  /// @}

  /// \name Creation
  /// @{

  /// finds the maps that the mesh has kept, or makes them with their initial values
  ConformalMeshTraits(Triangle_mesh& mesh);

  /// @}

  /// \name Access
  /// @{

  /// rho on vertices
  Vertex_curvature_potential_map vertex_curvature_potential_map() const;

  /// rho on faces
  Face_curvature_potential_map face_curvature_potential_map() const;

  /// lambda
  Vertex_spin_map vertex_spin_map() const;

  /// the normals
  Vertex_normal_map vertex_normal_map() const;

  /// @}
};
