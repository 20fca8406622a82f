// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
#include <Conformal_geometry_processing/parameterization/spectral_parameterization.h>

#include <Conformal_geometry_processing/measure/distortion.h>
#include <Conformal_geometry_processing/mesh/topology.h>
#include <Conformal_geometry_processing/operators/cotan_laplacian.h>
#include <Quaternionic_linear_algebra/direct/Ordering.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace Conformal_geometry_processing {

Hermitian_sparse_matrix<std::complex<double>> conformal_energy(
    const Mesh_view& mesh, std::shared_ptr<const Sparse_pattern> pattern)
{
  Hermitian_sparse_matrix<std::complex<double>> L(std::move(pattern));
  const Eigen::VectorXd w = cotan_weights(mesh);
  for (int k = 0; k < mesh.size_of_edges(); ++k) {
    L.value(L.pattern().find(mesh.ends(k)[1], mesh.ends(k)[0])) -= w[k];
    for (const int v : mesh.ends(k)) L.value(diagonal_position(L.pattern(), v)) += w[k];
  }
  // Twice the area is the sum of Im(conjugate(z_i) z_j) along the boundary; row i gets i/2.
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    if (mesh.twin(h) < 0)
      L.value(L.pattern().find(mesh.ends(mesh.edge(h))[1], mesh.ends(mesh.edge(h))[0])) +=
          std::complex<double>(0, mesh.from(h) > mesh.to(h) ? 0.5 : -0.5);
  return L;
}

Hermitian_sparse_matrix<std::complex<double>> conformal_energy(const Mesh_view& mesh)
{
  return conformal_energy(mesh, vertex_graph(mesh));
}

namespace internal {

/// The energy of one face as a matrix for (a_0, b_0, a_1, b_1, a_2, b_2)
/// \param cosines of the angles between the normals of its corners and its own
Eigen::Matrix<double, 6, 6> vertex_normal_energy_of_face(const Mesh_view& mesh, int f,
                                                         const Eigen::Vector3d& cosines)
{
  Eigen::Matrix3d e;
  for (int c = 0; c < 3; ++c) e.col(c) = mesh.vector(3 * f + c);
  const Eigen::Matrix3d K = e.transpose() * e / (2 * mesh.double_area_vector(f).norm());
  Eigen::Matrix<double, 6, 6> E = Eigen::Matrix<double, 6, 6>::Zero();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      E(2 * i, 2 * j) = K(i, j);
      E(2 * i + 1, 2 * j + 1) = cosines[i] * cosines[j] * K(i, j);
    }
    const int next = (i + 1) % 3;  // area <J grad phi_i, grad phi_next> = 1/2
    E(2 * i, 2 * next + 1) = E(2 * next + 1, 2 * i) = -cosines[next] / 2;
    E(2 * next, 2 * i + 1) = E(2 * i + 1, 2 * next) = cosines[i] / 2;
  }
  return E;
}

}  // namespace internal

Hermitian_sparse_matrix<double> vertex_normal_energy(const Mesh_view& mesh, const Points& normals,
                                                     const Sparse_pattern& graph)
{
  auto pattern = std::make_shared<const Sparse_pattern>(expanded_pattern(graph, 2));
  Hermitian_sparse_matrix<double> L(pattern);
  for (int f = 0; f < mesh.size_of_faces(); ++f) {
    const std::array<int, 3>& v = mesh.corners(f);
    const Eigen::Vector3d normal = stable_normalized(mesh.double_area_vector(f));
    Eigen::Vector3d cosines;
    for (int c = 0; c < 3; ++c)
      cosines[c] = normals.col(v[static_cast<std::size_t>(c)]).dot(normal);
    const auto E = internal::vertex_normal_energy_of_face(mesh, f, cosines);
    for (int r = 0; r < 6; ++r)
      for (int s = 0; s < 6; ++s) {
        const int i = 2 * v[static_cast<std::size_t>(r / 2)] + r % 2,
                  j = 2 * v[static_cast<std::size_t>(s / 2)] + s % 2;
        if (i >= j) L.value(pattern->find(i, j)) += E(r, s);
      }
  }
  return L;
}

std::ostream& operator<<(std::ostream& out, const Parameterization_report& r)
{
  out << "eigenvector            " << (r.converged ? "found" : "NOT found") << ", residual "
      << r.residual << " after " << r.iterations << " iterations\n"
      << "eigenvalue             " << r.eigenvalue << " (next one " << r.next_eigenvalue << ")\n";
  internal::print_conformality(out, r.conformality);
  return out;
}

void require_boundary(const Mesh_view& mesh, const std::string& function)
{
  for (int h = 0; h < mesh.size_of_halfedges(); ++h)
    if (mesh.twin(h) < 0) return;
  throw Precondition_error(function,
                           "the surface is closed; one with a boundary is needed, cut it open");
}

namespace internal {

/// \brief Finds the map z = a + i b to the plane that minimizes an energy under the constraint that
/// the sum of |z - mean|^2 over the vertices of some loops is one.
///
/// Energies that are invariant under rotations of the image are complex matrices, |V| x |V|; other
/// energies are real matrices, 2|V| x 2|V|, in the order a_0, b_0, a_1, b_1, ...
class Least_energy_map {
  using Complex = std::complex<double>;

 public:
  /// \param loops the constrained ones; the first one has at least three edges
  Least_energy_map(const Mesh_view& mesh, const std::vector<Vertex_loop>& loops,
                   const Map_solvers& solvers, std::string function)
      : m_mesh(mesh),
        m_start(circle_maps(mesh, loops, (std::min)(4, static_cast<int>(loops[0].size()) - 1))),
        m_weights(Eigen::VectorXd::Zero(mesh.size_of_vertices())),
        m_solvers(solvers),
        m_function(std::move(function))
  {
    for (const Vertex_loop& loop : loops)
      for (const int v : loop) m_weights[v] = 1;
  }

  /// \param report receives the results of the eigensolver, and the seconds
  /// \throw Solver_error if a factorization fails
  Eigen::VectorXcd find(const Hermitian_sparse_matrix<Complex>& energy,
                        const Subspace_options& options, Parameterization_report& report) const
  {
    Solver_ref<Complex> solver = m_solvers.solver<Complex>();
    Stopwatch watch;
    check("analysis", solver.analyze_with_positions(energy.pattern(), m_mesh.positions()));
    report.seconds.setup = watch.lap();
    const Centered_mass<Complex> mass(m_weights, Eigen::MatrixXcd::Ones(m_weights.size(), 1));
    return eigenvector(energy, solver, mass, m_weights, m_start, options, report);
  }

  Eigen::VectorXcd find(const Hermitian_sparse_matrix<double>& energy,
                        const Subspace_options& options, Parameterization_report& report) const
  {
    const Eigen::Index n = m_weights.size(), k = m_start.cols();
    Solver_ref<double> solver = m_solvers.solver<double>();
    Stopwatch watch;
    const Ordering order = amd_ordering(*vertex_graph(m_mesh));
    check("analysis", solver.analyze(energy.pattern(), expanded_ordering(order, 2)));
    report.seconds.setup = watch.lap();
    Eigen::VectorXd weights(2 * n);
    weights << m_weights, m_weights;
    weights = interleaved(weights);
    Eigen::MatrixXd start(2 * n, 2 * k), constants = Eigen::MatrixXd::Zero(2 * n, 2);
    start << m_start.real(), -m_start.imag(), m_start.imag(), m_start.real();
    constants.topLeftCorner(n, 1).setOnes();
    constants.bottomRightCorner(n, 1).setOnes();
    const Centered_mass<double> mass(weights, interleaved(constants));
    const Eigen::VectorXd ab =
        eigenvector(energy, solver, mass, weights, interleaved(start), options, report);
    return Eigen::Map<const Eigen::VectorXcd>(reinterpret_cast<const Complex*>(ab.data()), n);
  }

 private:
  /// Reorders rows 0 ... n-1, n ... 2n-1 to 0, n, 1, n+1, ...
  static Eigen::MatrixXd interleaved(const Eigen::MatrixXd& x)
  {
    const Eigen::Index n = x.rows() / 2;
    Eigen::MatrixXd y(x.rows(), x.cols());
    for (Eigen::Index i = 0; i < n; ++i) {
      y.row(2 * i) = x.row(i);
      y.row(2 * i + 1) = x.row(n + i);
    }
    return y;
  }

  template <class Scalar>
  Vector<Scalar> eigenvector(const Hermitian_sparse_matrix<Scalar>& energy,
                             Solver_ref<Scalar>& solver, const Centered_mass<Scalar>& mass,
                             const Eigen::VectorXd& weights, const Block<Scalar>& start,
                             const Subspace_options& options, Parameterization_report& report) const
  {
    Stopwatch watch;
    const double shift = factorize(energy, weights, solver);
    report.seconds.factorization = watch.lap();
    Subspace_result<Scalar> result =
        subspace_iteration(energy, mass, shift, solver, start, options);
    check("solution", result.status);
    report.seconds.eigenvector = watch.lap();
    report.converged = result.converged;
    report.eigenvalue = result.eigenvalue;
    report.next_eigenvalue = result.next_eigenvalue;
    report.residual = result.residual;
    report.iterations = result.iterations;
    report.normalized_vertices = static_cast<int>(m_weights.sum());
    return std::move(result.vector);
  }

  /// Factors energy + shift weights, because the energy vanishes for constants. Constants then have
  /// the energy `constant`, far below that of all maps except those of flat surfaces; it must
  /// exceed the rounding errors of the zero eigenvalue, which are large for meshes with slivers.
  template <class Scalar>
  double factorize(const Hermitian_sparse_matrix<Scalar>& energy, const Eigen::VectorXd& weights,
                   Solver_ref<Scalar>& solver) const
  {
    Solver_status status = Solver_status::success;
    for (const double constant : {1e-8, 1e-6, 1e-4}) {
      const double shift = constant / m_weights.sum();
      status = solver.factorize(energy, shift * weights);
      if (status == Solver_status::success) return shift;
      if (status != Solver_status::not_positive_definite) break;
    }
    check("factorization", status);
    return 0;
  }

  void check(const char* step, Solver_status status) const
  {
    if (status != Solver_status::success)
      throw Solver_error(
          m_function, std::string(step) + " of the conformal energy failed: " + to_string(status));
  }

  const Mesh_view& m_mesh;
  Eigen::MatrixXcd m_start;   // |V| x up to 4
  Eigen::VectorXd m_weights;  // |V|: 1 on the loops
  Map_solvers m_solvers;
  std::string m_function;
};

void certify(const Mesh_view& mesh, const Eigen::VectorXcd& z, Parameterization_report& report)
{
  const Points positions = in_space(z);
  Points upward = Points::Zero(3, mesh.size_of_faces());
  upward.row(2).setOnes();
  report.boundary_loops = static_cast<int>(boundary_loops(mesh).size());
  report.conformality = conformality(mesh, positions, upward);
  report.uniform_quasi_conformal = distribution(quasi_conformal_errors(mesh, positions),
                                                Eigen::VectorXd::Ones(mesh.size_of_faces()));
  report.converged = report.converged && z.allFinite();
  if (report.converged)
    report.overlap = overlap_summary(overlaps(mesh, positions), mesh, positions);
}

/// against the energy, which is dimensionless: the sides of a seam differ by its inverse
const double seam_stiffness = 1e5;

Eigen::VectorXcd least_energy_map(const Mesh_view& mesh, const std::vector<Vertex_loop>& loops,
                                  const Parameterization_options& options,
                                  Parameterization_report& report, const std::string& function)
{
  Subspace_options subspace;
  subspace.tolerance = options.tolerance;
  subspace.maximum_number_of_iterations = options.maximum_number_of_iterations;
  const auto graph = vertex_graph(mesh);
  Stopwatch watch;
  if (options.normals == Parameterization_options::Normals::of_faces) {
    auto energy = conformal_energy(mesh, graph_with_seams(mesh, options.seams));
    add_seams(options.seams, seam_stiffness, energy);
    report.seconds.assembly = watch.lap();
    return Least_energy_map(mesh, loops, options.solvers, function).find(energy, subspace, report);
  }
  const auto energy =
      vertex_normal_energy(mesh, vertex_normals(mesh, options.vertex_normals), *graph);
  report.seconds.assembly = watch.lap();
  return Least_energy_map(mesh, loops, options.solvers, function).find(energy, subspace, report);
}

}  // namespace internal

internal::Parameterization_result spectral_parameterization_of(
    Mesh_view mesh, const std::vector<internal::Vertex_loop>& loops,
    const Parameterization_options& options, const std::string& function)
{
  const internal::Normalized_frame frame(mesh.positions());
  mesh.set_positions(frame.to_frame(mesh.positions()));
  internal::Parameterization_result result;
  result.z = internal::least_energy_map(mesh, loops, options, result.report, function);
  result.z = place_in_plane(mesh, std::move(result.z), loops[0]);
  internal::Stopwatch watch;
  internal::certify(mesh, result.z, result.report);
  result.report.seconds.certificate = watch.lap();
  result.z *= frame.unit();
  return result;
}

internal::Parameterization_result spectral_parameterization(const Mesh_view& mesh,
                                                            const Parameterization_options& options,
                                                            const std::string& function)
{
  require_surface(mesh, function);
  require_boundary(mesh, function);
  return spectral_parameterization_of(mesh, normalized_loops(mesh, options.boundary), options,
                                      function);
}

}  // namespace Conformal_geometry_processing
