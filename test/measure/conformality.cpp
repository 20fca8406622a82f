// Copyright 2026 Conformal Geometry Processing authors, SPDX-License-Identifier: LGPL-3.0-or-later
// Tests mesh/Surface_ref.h
#include <Conformal_geometry_processing/measure/Conformality.h>
#include <Conformal_geometry_processing/measure/distortion.h>

#include <gtest/gtest.h>

#include "support/bounded_meshes.h"
#include "support/meshes.h"

#include <array>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <sstream>
#include <thread>
#include <vector>

namespace cgp_test::conformality_tests {

namespace CGP = Conformal_geometry_processing;

Points upward(const Mesh_view& mesh)
{
  return Eigen::Vector3d::UnitZ().replicate(1, mesh.size_of_faces());
}

TEST(Conformality, of_a_similarity_is_perfect)
{
  const Mesh_view mesh = grid(4, 3);
  Random random(5);
  const Eigen::Matrix3d R = random.rotation();
  const Points moved = (2.5 * R * mesh.positions()).colwise() + random.vector();
  const CGP::Conformality c = CGP::conformality(mesh, moved, R * upward(mesh));
  EXPECT_NEAR(c.quasi_conformal.mean, 1, 1e-14);
  EXPECT_NEAR(c.quasi_conformal.max, 1, 1e-14);
  EXPECT_NEAR(c.length_cross_ratio.max, 0, 1e-14);
  EXPECT_NEAR(c.scale.min_scale, 2.5, 1e-13);
  EXPECT_NEAR(c.scale.max_scale, 2.5, 1e-13);
  EXPECT_EQ(c.flipped_faces, 0);
}

TEST(Conformality, does_not_depend_on_the_unit)
{
  const Mesh_view mesh = bumpy_sphere(2);
  const Points moved = mapped(mesh, [](const Eigen::Vector3d& p) {
                         return Eigen::Vector3d(p.x() + .2 * p.y(), 1.3 * p.y(), p.z() + 5);
                       }).positions();
  const CGP::Conformality c =
      CGP::conformality(mesh, moved, CGP::neighbourhood_normals(mesh, moved));
  for (const double unit : {1e-150, 1e-80, 1e80, 1e150}) {
    const Mesh_view other = scaled(mesh, unit);
    const Points moved_there = unit * moved;
    const CGP::Conformality d =
        CGP::conformality(other, moved_there, CGP::neighbourhood_normals(other, moved_there));
    EXPECT_NEAR(d.quasi_conformal.mean, c.quasi_conformal.mean, 1e-12) << unit;
    EXPECT_NEAR(d.quasi_conformal.max, c.quasi_conformal.max, 1e-11) << unit;
    EXPECT_NEAR(d.quasi_conformal_of_new_area, c.quasi_conformal_of_new_area, 1e-12) << unit;
    EXPECT_NEAR(d.scale.min_scale, c.scale.min_scale, 1e-12) << unit;
    EXPECT_NEAR(d.scale.max_scale, c.scale.max_scale, 1e-12) << unit;
    EXPECT_NEAR(d.length_cross_ratio.rms, c.length_cross_ratio.rms, 1e-12) << unit;
    EXPECT_EQ(d.flipped_faces, c.flipped_faces) << unit;
  }
}

TEST(Conformality, of_a_stretch_and_a_reflection_shows_in_every_part)
{
  const Mesh_view mesh = grid(1, 1);
  const Points moved = Eigen::Vector3d(3, -1, 1).asDiagonal() * mesh.positions();
  const CGP::Conformality c = CGP::conformality(mesh, moved, upward(mesh));
  EXPECT_NEAR(c.quasi_conformal.mean, 3, 1e-14);
  EXPECT_NEAR(c.quasi_conformal.p99, 3, 1e-14);
  // The two sides along x grow by 3, those along y by 1: the cross-ratio of the diagonal by 9.
  EXPECT_NEAR(c.length_cross_ratio.max, std::log(9.), 1e-14);
  EXPECT_NEAR(c.scale.max_scale, std::sqrt(3.), 1e-14);
  EXPECT_EQ(c.flipped_faces, 2);
}

TEST(Conformality_io, prints_one_fact_per_line)
{
  Conformal_geometry_processing::Conformality c;
  c.quasi_conformal = {1.015625, 1.03125, 1.0625};
  c.length_cross_ratio = {0.002, 0.005};
  c.scale.min_scale = 0.5;
  c.scale.max_scale = 3;
  c.flipped_faces = 7;
  std::ostringstream out;
  Conformal_geometry_processing::internal::print_conformality(out, c);
  EXPECT_EQ(out.str(),
            "quasi-conformal error  1.01562 mean, 1.03125 for 99 %, 1.0625 at most (1 is "
            "conformal)\n"
            "length cross-ratios    changed by 0.002 rms, 0.005 at most (0 is conformal)\n"
            "lengths                scaled by 0.5 to 3\n"
            "flipped faces          7\n");
}

/// what several threads sum, each its part
class Meeting {
 public:
  explicit Meeting(int threads) : m_threads(threads) {}

  Eigen::VectorXd sum(const Eigen::VectorXd& own)
  {
    return together(own, [](const auto& a, const auto& b) { return Eigen::VectorXd(a + b); });
  }
  double largest(double own)
  {
    return together(Eigen::VectorXd::Constant(1, own),
                    [](const auto& a, const auto& b) { return Eigen::VectorXd(a.cwiseMax(b)); })[0];
  }

 private:
  template <class Join>
  Eigen::VectorXd together(const Eigen::VectorXd& own, const Join& join)
  {
    std::unique_lock lock(m_mutex);
    const int round = m_round;
    m_all = m_arrived == 0 ? own : join(m_all, own);
    if (++m_arrived == m_threads) {
      m_result = m_all;
      m_arrived = 0;
      ++m_round;
      m_changed.notify_all();
    }
    m_changed.wait(lock, [&] { return m_round != round; });
    return m_result;
  }

  std::mutex m_mutex;
  std::condition_variable m_changed;
  Eigen::VectorXd m_all, m_result;
  int m_threads, m_arrived = 0, m_round = 0;
};

/// each part counts every third face, which comes first, and every third edge
TEST(Conformality, of_parts_is_that_of_the_whole)
{
  const Mesh_view mesh = disk(5);
  const Points moved = mapped(mesh, [](const Eigen::Vector3d& p) {
                         return Eigen::Vector3d(p.x() + .3 * p.y() * p.y(), 1.3 * p.y(), p.x());
                       }).positions();
  const auto measured = [&](const Mesh_view& m, const CGP::internal::Surface_part& part) {
    return CGP::internal::measured_conformality(m, moved, upward(m), part);
  };
  const CGP::Conformality c = measured(mesh, {});
  const int parts = 3;
  Meeting meeting(parts);
  std::vector<CGP::Conformality> found(parts);
  std::vector<std::thread> threads;
  for (int p = 0; p < parts; ++p)
    threads.emplace_back([&, p] {
      std::vector<std::array<int, 3>> own, all;
      for (int f = 0; f < mesh.size_of_faces(); ++f)
        (f % parts == p ? own : all).push_back(mesh.corners(f));
      CGP::internal::Surface_part part;
      part.faces = static_cast<int>(own.size());
      all.insert(all.begin(), own.begin(), own.end());
      const Mesh_view m(mesh.positions(), all);
      part.is_own_edge = [&](int k) { return (m.ends(k)[0] + m.ends(k)[1]) % parts == p; };
      part.sum_of_parts = [&](const Eigen::VectorXd& sums) { return meeting.sum(sums); };
      part.largest_of_parts = [&](double value) { return meeting.largest(value); };
      found[static_cast<std::size_t>(p)] = measured(m, part);
    });
  for (std::thread& thread : threads) thread.join();
  for (const CGP::Conformality& d : found) {
    EXPECT_NEAR(d.quasi_conformal.mean, c.quasi_conformal.mean, 1e-13);
    EXPECT_EQ(d.quasi_conformal.p99, c.quasi_conformal.p99);
    EXPECT_EQ(d.quasi_conformal.max, c.quasi_conformal.max);
    EXPECT_NEAR(d.quasi_conformal_of_new_area, c.quasi_conformal_of_new_area, 1e-13);
    EXPECT_NEAR(d.length_cross_ratio.rms, c.length_cross_ratio.rms, 1e-13);
    EXPECT_NEAR(d.length_cross_ratio.max, c.length_cross_ratio.max, 1e-13);
    EXPECT_EQ(d.scale.min_scale, c.scale.min_scale);
    EXPECT_EQ(d.scale.max_scale, c.scale.max_scale);
    EXPECT_NEAR(d.scale.log_deviation, c.scale.log_deviation, 1e-13);
    EXPECT_NEAR((d.scale.histogram - c.scale.histogram).norm(), 0, 1e-13);
    EXPECT_EQ(d.flipped_faces, c.flipped_faces);
    EXPECT_EQ(d.flipped_share, c.flipped_share);
  }
}

}  // namespace cgp_test::conformality_tests
