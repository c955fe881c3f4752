#include "libmpm/moving_solver.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "tests/libmpm/moving_scenes.hpp"

namespace {

using mpm::Scene;
using samples::Method;
using samples::Moving;

/// A disc that turns and flies askew through the cells.
Scene thrown_disc() {
  Scene scene = samples::soft_body(24, 24, 0.05, 0.2);
  samples::keep_disc(scene, 11, 12, 9);
  scene.motion.margin = 0.6;
  return scene;
}
template <class Real>
void throw_it(Moving<Real>& it) {
  it.solver.kick([](const mpm::PointView& p, double& vx, double& vy) {
    vx = 7 - 20 * (p.y - 0.6) + 3 * (p.x - 0.55);
    vy = 4 + 20 * (p.x - 0.55);
  });
}

template <class Real>
std::vector<mpm::PointView> after(Scene scene, int threads, int steps) {
  scene.threads = threads;
  Moving<Real> it(std::move(scene));
  throw_it(it);
  EXPECT_EQ(it.solver.advance(steps).trouble, "");
  return it.solver.points();
}

bool same_bits(const std::vector<mpm::PointView>& a, const std::vector<mpm::PointView>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto& p = a[i];
    const auto& q = b[i];
    const double values_p[] = {p.x, p.y, p.vx, p.vy, p.mass, p.volume, p.stress.xx, p.stress.yy, p.stress.xy};
    const double values_q[] = {q.x, q.y, q.vx, q.vy, q.mass, q.volume, q.stress.xx, q.stress.yy, q.stress.xy};
    if (p.id != q.id || std::memcmp(values_p, values_q, sizeof values_p) != 0 ||
        std::memcmp(p.gradient, q.gradient, sizeof p.gradient) != 0)
      return false;
  }
  return true;
}

// The order of every sum is fixed by the tiles, so that the number of bands cannot show, while points cross
// cells in both directions.
template <class Real>
void expect_same_bits_for_any_threads() {
  for (const Method& method : samples::all_methods()) {
    Scene scene = thrown_disc();
    method.give_to(scene);
    SCOPED_TRACE(method.name());
    const auto one = after<Real>(scene, 1, 60);
    ASSERT_FALSE(one.empty());
    for (const int threads : {2, 3, 5})
      EXPECT_TRUE(same_bits(one, after<Real>(scene, threads, 60))) << threads;
  }
}
TEST(Threads, GiveTheSameBitsInDouble) { expect_same_bits_for_any_threads<double>(); }
TEST(Threads, GiveTheSameBitsInSingle) { expect_same_bits_for_any_threads<float>(); }

TEST(Threads, PointsCrossCellsInThoseTests) {
  Moving<double> it(thrown_disc());
  throw_it(it);
  std::vector<mpm::PointView> before = it.solver.points();
  (void)it.solver.advance(60);
  double furthest = 0;
  for (const auto& p : it.solver.points())
    for (const auto& q : before)
      if (p.id == q.id) furthest = std::max(furthest, std::hypot(p.x - q.x, p.y - q.y));
  EXPECT_GT(furthest, 1.5 * it.plan.cell_size);
}

}  // namespace
