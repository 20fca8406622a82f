// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <Conformal_geometry_processing/mesh/Mesh_view.h>
#include <Conformal_geometry_processing/mesh/Surface_ref.h>
#include <Quaternionic_linear_algebra/algebra/Quaternion_vector.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace Conformal_geometry_processing::internal {

struct Index_range;

/// weights of the residuals of a `Dirac_misfit`, numbers without a unit
struct Misfit_weights {
  double sheets = 0.2;
  double vertices = 0;  ///< 0: `default_vertex_weight()`
  double factor = 1;    ///< of both

  double sum() const { return sheets + vertices; }
};

/// \brief the residual of the Dirac equation (D - rho) lambda = 0, relative to |lambda|, on sheets
/// and at vertices, and its derivative dr = A y - N d for changes y of lambda and d of rho.
///
/// On a sheet s and at a vertex v, with M the areas of sheets and B the average over their corners,
///
///     r_s = (D lambda - B (rho lambda)) / |lambda|,
///     r_v = (M_V^-1 B^H M D lambda - rho lambda) / |lambda|,
///
/// weighted by M and `Misfit_weights::sheets`, M_V and `Misfit_weights::vertices`; on a sheet,
/// |lambda| is the root of the mean of |lambda|^2 at its corners. The real part is what the change
/// of curvature (D lambda) lambda^-1 lacks to rho. It does not become smaller where lambda does:
/// otherwise a limb that cannot take the shape of rho would shrink.
///
/// The sheets have twice as many equations as there are unknowns, so that no lambda solves these;
/// but what even the eigenvector of (5.3) leaves of them oscillates from sheet to sheet, and its
/// averages at vertices are of second order. Only those may weigh much: a large weight of the
/// sheets asks for less curvature. All functions are O(sheets), and real-linear.
class Dirac_misfit {
 public:
  using Spins = Quaternion_vector<double>;

  /// a `Sheet`, in as few numbers as the loops need
  struct Triangle {
    std::array<int, 3> corners;
    double area, share;
    std::array<Eigen::Vector3d, 2> half_edges;  ///< opposite the first two corners
  };

  /// what does not depend on lambda and rho: the sheets, and M_V
  struct Geometry {
    Surface_part part;
    std::vector<Triangle> sheets;
    Eigen::VectorXd areas;

    explicit Geometry(const Surface_ref& surface, const Surface_part& part = {});
  };

  /// \param geometry must outlive the object
  /// \param rho |V|, in 1/length
  Dirac_misfit(const Geometry& geometry, const Misfit_weights& weights, Eigen::VectorXd rho,
               Spins lambda);

  /// z on sheets, then at vertices, and N^T W z with the weights W, |V|, which are found in one
  /// pass. On every surface, N^T W N <= (the sum of the weights) M_V.
  struct Image {
    Spins misfit;
    Eigen::VectorXd turned;
  };

  const Spins& lambda() const { return m_lambda; }
  const Eigen::VectorXd& rho() const { return m_rho; }

  const Image& residual() const { return m_residual; }  ///< of r, in 1/length
  Image apply(const Spins& y) const;                    ///< of A y
  /// A^H W (z - N d), |V|
  Spins adjoint(const Spins& z, const Eigen::VectorXd& d) const;
  double squared_norm(const Spins& z) const;  ///< <z, W z>

 private:
  int sheets() const { return static_cast<int>(m_geometry->sheets.size()); }
  /// those where functions sum up
  int vertices() const { return m_geometry->part.own_vertices(m_lambda.size()); }
  template <class Visit>
  void for_each_owned_sheet(const Visit& visit) const;
  double growth(int i, const Spins& y) const;
  template <class Finish>
  Image image(const Spins& y, const Finish& finish) const;
  void add_turned(const Index_range& own, const Triangle& sheet, int s, const Quaternion<double>& z,
                  Eigen::VectorXd& d) const;
  double turned_at(Eigen::Index v, const Quaternion<double>& z) const;

  const Geometry* m_geometry;
  Misfit_weights m_weights;
  Eigen::VectorXd m_rho;
  Spins m_lambda;
  Eigen::VectorXd m_inverses;  // 1 / |lambda|: sheets, then vertices
  Image m_residual;
};

/// \brief how much spins leave of the equation, in 1/length: the root mean squares of r_s and r_v
/// of `Dirac_misfit` over the area.
struct Misfit_sizes {
  double sheets, vertices;

  /// whether the edge length explains what is left: it averages out around vertices, where it is of
  /// second order; what belongs to no solution stays
  bool averages_out() const { return vertices < 0.9 * sheets; }
};

/// \param rho |V| \param lambda |V|
Misfit_sizes misfit_sizes(const Dirac_misfit::Geometry& geometry, const Eigen::VectorXd& rho,
                          const Quaternion_vector<double>& lambda);

}  // namespace Conformal_geometry_processing::internal
