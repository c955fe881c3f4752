// The rate-free tension test of an independent program, on a specimen and a strength field that were given to
// both.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "libmpm/solver/plan.hpp"
#include "libmpm/solver/quasi_static/quasi_static_solver.hpp"

namespace rate_free_test {

namespace fs = std::filesystem;
using mpm::Ledger;
using mpm::Scene;

constexpr int side = 300;

/// Folder of lab_s2.pgm and what belongs to it: shared/reference in or beside the source tree.
fs::path reference() {
  for (const char* place : {"shared/reference", "../shared/reference"})
    if (const fs::path path = fs::path(MESOPIX_SOURCE_DIR) / place; fs::exists(path / "lab_s2.pgm"))
      return path;
  return {};
}

class RateFree : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = reference();
    if (folder_.empty()) GTEST_SKIP() << "shared/reference is neither in nor beside the source tree";
    scene_.labels.resize(side, side);
    std::ifstream picture(folder_ / "lab_s2.pgm", std::ios::binary);
    std::string magic;
    int width = 0;
    int height = 0;
    int most = 0;
    picture >> magic >> width >> height >> most;
    ASSERT_EQ(width, side);
    picture.get();
    picture.read(reinterpret_cast<char*>(scene_.labels.data()), side * side);
    factors_.resize(side, side);
    std::ifstream(folder_ / "lab_s2_q.f64", std::ios::binary)
        .read(reinterpret_cast<char*>(factors_.data()), side * side * 8);
    const auto phases = mpm::concrete_phases();
    scene_.phases = {std::nullopt, phases[0], phases[1], phases[2]};
    scene_.pixel_size = 0.5e-3;
    scene_.method = mpm::SolverMethod::quasi_static;
    scene_.loading.stop_strain = 1e-3;
  }

  [[nodiscard]] double strain(const Ledger& ledger) const {
    return ledger.platen_displacement / scene_.height();
  }
  [[nodiscard]] double stress(const Ledger& ledger) const {
    return 0.5 * (ledger.force_top - ledger.force_bottom) / scene_.width();
  }

  fs::path folder_;
  Scene scene_;
  mpm::PixelField<double> factors_;
};

/// Compares the first events, one failure at a time, with those of the other program.
class PointByPoint : public RateFree {
 protected:
  void SetUp() override {
    RateFree::SetUp();
    scene_.event_tolerance = 0;
    table_.open(folder_ / "lab_s2_events.csv");
    std::getline(table_, line_);
  }

  void expect_event(const Ledger& ledger) {
    ASSERT_TRUE(std::getline(table_, line_));
    std::replace(line_.begin(), line_.end(), ',', ' ');
    std::istringstream cells(line_);
    int number = 0;
    int row = 0;
    int col = 0;
    int mode = 0;
    double at = 0;
    double under = 0;
    cells >> number >> row >> col >> mode >> at >> under;
    EXPECT_NEAR(strain(ledger), at, 1e-4 * at) << number;
    EXPECT_NEAR(stress(ledger), under, 1e-4 * under) << number;
  }

  std::ifstream table_;
  std::string line_;
};

TEST_F(PointByPoint, FailsAsTheOtherProgram) {
  const mpm::Plan plan = mpm::plan(scene_);
  mpm::QuasiStaticSolver solver(scene_, plan, factors_);
  mpm::Result maps;
  for (int event = 0; event < 60; ++event) {
    const Ledger ledger = solver.advance(1);
    if (event == 0) {
      EXPECT_NEAR(stress(ledger) / strain(ledger), 27.2327e9, 1e5);
    }
    ASSERT_NO_FATAL_FAILURE(expect_event(ledger));
    if (event == 0) continue;
    solver.copy_maps(maps);
    EXPECT_EQ((maps.failure_mode > 0).count(), event);
  }
}

// Runs for long: with the tests of ./check all.
TEST_F(PointByPoint, ReachesTheSamePeak) {
  const mpm::Plan plan = mpm::plan(scene_);
  mpm::QuasiStaticSolver solver(scene_, plan, factors_);
  double peak = 0;
  double at = 0;
  for (int event = 0; !solver.is_done(); ++event) {
    const Ledger ledger = solver.advance(1);
    if (event < 500) {
      ASSERT_NO_FATAL_FAILURE(expect_event(ledger));
    }
    if (stress(ledger) > peak) {
      peak = stress(ledger);
      at = strain(ledger);
    }
    if (stress(ledger) < 0.8 * peak) break;
  }
  EXPECT_NEAR(peak, 3.6507e6, 0.0005e6);
  EXPECT_NEAR(at, 152.95e-6, 0.02e-6);
}

TEST_F(RateFree, ReachesTheSamePeakWithFailuresAtOnce) {
  scene_.event_tolerance = 0.02;
  const mpm::Plan plan = mpm::plan(scene_);
  mpm::QuasiStaticSolver solver(scene_, plan, factors_);
  double peak = 0;
  double at = 0;
  while (!solver.is_done()) {
    const Ledger ledger = solver.advance(1);
    if (stress(ledger) > peak) {
      peak = stress(ledger);
      at = strain(ledger);
    }
    if (stress(ledger) < 0.8 * peak) break;
  }
  EXPECT_NEAR(peak, 3.589e6, 0.002e6);
  EXPECT_NEAR(at, 149.8e-6, 0.1e-6);
}

}  // namespace rate_free_test
