// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Edits one surface many times without a mesh class: reuses data from edit to edit, and counts the
// calls of a user-defined linear solver.
//
//   many_edits [INPUT [OUTPUT.ply [STRENGTH]]]
//
// The mesh consists of two arrays; the linear solver is the library's own with a counter, a minimal
// model of SparseHermitianSolver.
#include <Conformal_geometry_processing/spin/Spin_transformation.h>

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace CGP = Conformal_geometry_processing;
using Point = CGAL::Simple_cartesian<double>::Point_3;

//! [solver]
int factorizations = 0;

template <class Scalar>
struct Counting_solver : CGP::Supernodal_cholesky<Scalar> {
  using Base = CGP::Supernodal_cholesky<Scalar>;
  CGP::Solver_status factorize(const CGP::Hermitian_sparse_matrix<Scalar>& matrix,
                               const CGP::Vector<double>& shift)
  {
    ++factorizations;
    return Base::factorize(matrix, shift);
  }
  CGP::Solver_status factorize_preconditioner(const CGP::Hermitian_sparse_matrix<Scalar>& matrix,
                                              const CGP::Vector<double>& shift)
  {
    ++factorizations;
    return Base::factorize_preconditioner(matrix, shift);
  }
};

struct Counting_solver_traits {
  template <class Scalar>
  using Solver = Counting_solver<Scalar>;
};
//! [solver]

int main(int argc, char* argv[])
{
  std::vector<Point> points;
  std::vector<std::array<int, 3>> faces;
  if (!CGAL::IO::read_polygon_soup(argc > 1 ? argv[1] : "sphere.off", points, faces)) return 1;
  const double strongest = argc > 3 ? std::atof(argv[3]) : 2;
  try {
    //! [arrays]
    CGP::Points positions(3, static_cast<Eigen::Index>(points.size()));
    for (Eigen::Index v = 0; v < positions.cols(); ++v) {
      const Point& p = points[static_cast<std::size_t>(v)];
      positions.col(v) << p.x(), p.y(), p.z();
    }
    const CGP::Mesh_view mesh(positions, faces);
    CGP::Spin_transformation_options options;
    options.solvers = Counting_solver_traits();
    CGP::Spin_transformation transformation(mesh, options);
    for (double strength = strongest / 4; strength <= strongest; strength += strongest / 4) {
      const Eigen::VectorXd bands = strength * (6 * positions.row(1).array()).sin();
      const CGP::Spin_result result =
          transformation.transform({CGP::Curvature_potential::On::vertices, bands});
      if (!result.report) return EXIT_FAILURE;
      std::cout << strength << ": mean quasi-conformal error "
                << result.report.conformality.quasi_conformal.mean << ", closure "
                << result.report.closure_residual << ", " << factorizations
                << " factorizations so far\n";
      positions = result.positions;
    }
    //! [arrays]
    for (std::size_t v = 0; v < points.size(); ++v) {
      const auto p = positions.col(static_cast<Eigen::Index>(v));
      points[v] = Point(p.x(), p.y(), p.z());
    }
  } catch (const CGP::Error& error) {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  const char* const output = argc > 2 ? argv[2] : "many_edits.ply";
  return CGAL::IO::write_polygon_soup(output, points, faces) ? EXIT_SUCCESS : EXIT_FAILURE;
}
