// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

using namespace Conformal_geometry_processing;

/// \ingroup PkgConcepts
/// \cgalConcept
///
/// \brief a surface as the operators see it: triangles that carry functions linear on them, laid
/// out in the planes of the faces of a mesh.
///
/// Every operator is a sum over the sheets of the surface: a `Sheet` is a triangle in the plane of
/// a face, with the share of its area that lies there. A mesh has one sheet for each face; a
/// triangle of an intrinsic triangulation has one for each face that it passes through. Operators
/// take a `Surface_ref`, which any model converts to, so they are compiled once for all models.
///
/// The free function `boundary_loops(surface)`, found by argument-dependent lookup, returns the
/// loops of boundary vertices, the surface on their left, or none on a closed surface.
///
/// Headers of these types:
/// - `Conformal_geometry_processing::Points`,
///   `Conformal_geometry_processing/mesh/Mesh_view.h`
/// - `Conformal_geometry_processing::Sheet`,
///   `Conformal_geometry_processing/mesh/Mesh_view.h`
/// - `Conformal_geometry_processing::Surface_ref`,
///   `Conformal_geometry_processing/mesh/Surface_ref.h`
///
/// \cgalHasModelsBegin
/// \cgalHasModels{`Conformal_geometry_processing::Mesh_view`}
/// \cgalHasModels{`Conformal_geometry_processing::Delaunay_view`}
/// \cgalHasModels{`Conformal_geometry_processing::Surface_ref`, but for `ends()`}
/// \cgalHasModelsEnd
class ConformalSurface {
 public:
  /// the positions of the vertices, 3 x |V|; always the same object while the surface lives
  const Points& positions() const;

  /// of the mesh: the number of values of a curvature on faces
  int size_of_faces() const;

  /// the vertices that each edge joins, the smaller number first, which orients 1-forms; they may
  /// be the same, or those of another edge. Always the same object while the surface lives
  const std::vector<std::array<int, 2>>& ends() const;

  /// how many sheets there are
  int size_of_sheets() const;

  /// sheet i; sheets of one triangle follow each other. Operators call it from several threads at
  /// the same time if `number_of_threads()` is not 1
  Sheet sheet(int i) const;
};
