// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

namespace cgp_test {

/// a point that offers nothing: neither a default nor its coordinates
class Point_archetype {
 public:
  Point_archetype() = delete;

 private:
  Point_archetype(double x, double y, double z) : m_coordinates{x, y, z} {}

  double m_coordinates[3];
  friend class Geometry_traits_archetype;
};

/// exactly `ConformalGeometryTraits_3`. It has a state, the unit of length, and no default.
class Geometry_traits_archetype {
 public:
  using FT = double;
  using Point_3 = Point_archetype;

  template <int axis>
  struct Compute_coordinate {
    double unit;
    FT operator()(const Point_3& p) const { return unit * p.m_coordinates[axis]; }
  };
  using Compute_x_3 = Compute_coordinate<0>;
  using Compute_y_3 = Compute_coordinate<1>;
  using Compute_z_3 = Compute_coordinate<2>;

  struct Construct_point_3 {
    double unit;
    Point_3 operator()(FT x, FT y, FT z) const { return {x / unit, y / unit, z / unit}; }
  };

  explicit Geometry_traits_archetype(double unit) : m_unit(unit) {}

  Compute_x_3 compute_x_3_object() const { return {m_unit}; }
  Compute_y_3 compute_y_3_object() const { return {m_unit}; }
  Compute_z_3 compute_z_3_object() const { return {m_unit}; }
  Construct_point_3 construct_point_3_object() const { return {m_unit}; }

 private:
  double m_unit;
};

}  // namespace cgp_test
