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

TEST_F(RateFree, FailsPointByPointAsTheOtherProgram) {
  scene_.event_tolerance = 0;
  const mpm::Plan plan = mpm::plan(scene_);
  mpm::QuasiStaticSolver solver(scene_, plan, factors_);
  std::ifstream table(folder_ / "lab_s2_events.csv");
  std::string line;
  std::getline(table, line);
  mpm::Result maps;
  for (int event = 0; event < 60; ++event) {
    const Ledger ledger = solver.advance(1);
    if (event == 0) {
      EXPECT_NEAR(stress(ledger) / strain(ledger), 27.2327e9, 1e5);
    }
    ASSERT_TRUE(std::getline(table, line));
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream cells(line);
    int number = 0;
    int row = 0;
    int col = 0;
    int mode = 0;
    double at = 0;
    double under = 0;
    cells >> number >> row >> col >> mode >> at >> under;
    EXPECT_NEAR(strain(ledger), at, 1e-4 * at) << number;
    EXPECT_NEAR(stress(ledger), under, 1e-4 * under) << number;
    if (event == 0) continue;
    solver.copy_maps(maps);
    EXPECT_EQ((maps.failure_mode > 0).count(), event);
  }
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
