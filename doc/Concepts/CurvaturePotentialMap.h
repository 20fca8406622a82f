// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later

using namespace Conformal_geometry_processing;

/// \ingroup PkgConcepts
/// \cgalConcept
///
/// \brief tells rho, the change of mean curvature that a transformation is asked for, in 1/length
/// of the mesh.
///
/// Whether rho lives on vertices or on faces is decided at compile time, by the key type. The map
/// is taken by value and only ever read, by `get(map, key)`: neither `operator[]` nor
/// `reference` is used.
///
/// \cgalRefines{`ReadablePropertyMap`}
///
/// \cgalHasModelsBegin
/// \cgalHasModels{The maps of a `ConformalMeshTraits`;}
/// \cgalHasModels{`CGAL::Constant_property_map`;}
/// \cgalHasModels{`boost::function_property_map`.}
/// \cgalHasModelsEnd
class CurvaturePotentialMap {
 public:
  /// the vertex or the face descriptor of the mesh
  typedef unspecified_type key_type;

  /// a number that `CGAL::to_double()` converts
  typedef unspecified_type value_type;
};
