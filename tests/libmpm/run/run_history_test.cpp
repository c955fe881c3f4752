#include "libmpm/run/run_history.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

#include "libmpm/run/simulate.hpp"
#include "libmpm/solver/lattice/cell_limit.hpp"
#include "tests/libmpm/moving_scenes.hpp"
#include "tests/libmpm/sample_scenes.hpp"

namespace run_history_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// What a run that must go wrong says; what it kept goes to `kept`.
std::string complaint(const mpm::Scene& scene, const mpm::Plan& plan, mpm::Result* kept = nullptr) {
  try {
    (void)mpm::simulate(scene, plan);
  } catch (const mpm::Diverged& diverged) {
    if (kept != nullptr) *kept = diverged.result;
    return diverged.what();
  }
  ADD_FAILURE() << "a diverging run must not end as if it were good";
  return {};
}

/// One stiff pixel in a soft block: nothing else bears less than the time step that is taken.
mpm::Scene one_stiff_pixel() {
  mpm::Scene scene = samples::unbreakable(samples::mortar_block(20, 20));
  scene.phases[samples::aggregate]->young = 2000e9;
  scene.labels(6, 13) = samples::aggregate;
  scene.loading.stop_strain = 0.5;
  return scene;
}

mpm::Plan too_long(const mpm::Scene& scene, double factor) {
  mpm::Plan plan = mpm::plan(scene);
  plan.dt = factor * mpm::cell_limit(scene, plan);
  return plan;
}

mpm::HistoryRow row_of(double strain, double top, double bottom) {
  mpm::HistoryRow row;
  row.strain = strain;
  row.stress_top = top;
  row.stress_bottom = bottom;
  row.stress = 0.5 * (top + bottom);
  return row;
}

TEST(PlatenImbalance, IsTheShareThatDoesNotPassThrough) {
  EXPECT_EQ(mpm::platen_imbalance(row_of(0, 0, 0)), 0);
  EXPECT_EQ(mpm::platen_imbalance(row_of(0, 3, 3)), 0);
  EXPECT_EQ(mpm::platen_imbalance(row_of(0, 3, 1)), 0.5);
  EXPECT_EQ(mpm::platen_imbalance(row_of(0, 3, 0)), 1);
  EXPECT_EQ(mpm::platen_imbalance(row_of(0, 3, -3)), 1);
}

// The first wave presses one platen alone; a row in balance or half so counts by the mean of both, as it
// always did.
TEST(AddRow, TakesNoWaveForThePeak) {
  mpm::Result result;
  for (const auto& row : {row_of(0, 0, 0), row_of(1e-6, 90, 0), row_of(1e-4, 10.5, 9.5), row_of(2e-4, 30, 2)})
    mpm::add_row(result, row, mpm::Direction::tension);
  EXPECT_EQ(result.peak_stress, 10);
  EXPECT_EQ(result.peak_strain, 1e-4);
  mpm::add_row(result, row_of(3e-4, 40, 12), mpm::Direction::tension);
  EXPECT_EQ(result.peak_stress, 12) << "what passes through";
}

TEST(AddRow, TakesAnyStressOnAWallThatIsHit) {
  mpm::Result result;
  mpm::add_row(result, row_of(0, 0, 90), mpm::Direction::none);
  EXPECT_EQ(result.peak_stress, 45);
}

TEST(DivergenceText, SaysWhatWhenWhereWhyAndTheCure) {
  mpm::Scene scene = samples::mortar_block(20, 20);
  scene.cfl = 1;
  const mpm::Plan plan = too_long(scene, 2);
  const std::string text = mpm::divergence_text(
      scene, plan,
      {"energy grows without work", 12, 3.5e-6, plan.dt, "the point of pixel (row 1, column 2)"});
  EXPECT_THAT(text, HasSubstr("energy grows without work at step 12 (time 3.5e-06 s), "
                              "worst at the point of pixel (row 1, column 2): the time step of "));
  EXPECT_THAT(text, HasSubstr(" s is too long for this specimen; try a smaller solver.cfl: "
                              "0.5 is safe for each of its cells"));
}

TEST(DivergenceText, LaysNoBlameOnATimeStepThatCellsBear) {
  mpm::Scene scene = samples::mortar_block(20, 20);
  const mpm::Plan plan = too_long(scene, 0.99);
  const std::string text =
      mpm::divergence_text(scene, plan, {"energy grows without work", 12, 0, plan.dt, ""});
  EXPECT_THAT(text, HasSubstr("try a smaller solver.cfl"));
  EXPECT_THAT(text, AllOf(Not(HasSubstr("worst at")), Not(HasSubstr("is safe"))));
}

TEST(DivergenceText, NamesTheCflThatIsSafe) {
  const mpm::Scene scene = one_stiff_pixel();
  mpm::Plan plan = mpm::plan(scene);
  plan.dt = 3 * mpm::cell_limit(scene, plan);
  const std::string text = complaint(scene, plan);
  const auto at = text.find("solver.cfl: ");
  ASSERT_NE(at, std::string::npos) << text;
  mpm::Scene cured = scene;
  cured.cfl = std::stod(text.substr(at + 12));
  // The plan's own step was made longer, not the cfl: the cure counts from the cfl and the step at hand.
  const double factor = cured.cfl / scene.cfl;
  EXPECT_LE(factor * plan.dt, mpm::cell_limit(scene, plan));
  EXPECT_GT(factor * plan.dt, 0.9 * mpm::cell_limit(scene, plan));
}

// Whether it is seen by its energy, a few steps later, or only as numbers that are none, after a long stretch
// without a look at the energy.
TEST(Diverged, NamesTheStiffPointAndItsPhase) {
  const mpm::Scene scene = one_stiff_pixel();
  for (const std::int64_t steps_per_row : {10, 100'000}) {
    mpm::Plan plan = too_long(scene, 1.5);
    plan.steps = 1'000'000;
    plan.steps_per_row = steps_per_row;
    mpm::Result kept;
    const std::string text = complaint(scene, plan, &kept);
    EXPECT_THAT(text, HasSubstr(steps_per_row == 10 ? "energy grows without work at step "
                                                    : "motion is not a number at step "));
    EXPECT_THAT(text,
                HasSubstr(steps_per_row == 10 ? "worst at the point of pixel (row 6, column 13), aggregate"
                                              : "worst at the point of pixel (row "));
    EXPECT_FALSE(kept.history.empty());
    EXPECT_LT(kept.peak_stress, 1e9) << "nothing of what went wrong is kept";
  }
}

TEST(Diverged, IsTheSameForAnyThreads) {
  mpm::Scene scene = one_stiff_pixel();
  std::string first;
  for (const int threads : {1, 2, 3}) {
    scene.threads = threads;
    mpm::Plan plan = too_long(scene, 1.5);
    plan.steps = plan.steps_per_row = 100'000;
    const std::string text = complaint(scene, plan);
    if (first.empty()) first = text;
    EXPECT_EQ(text, first) << threads;
  }
}

TEST(Diverged, NamesAMovingPointAndItsPhase) {
  mpm::Scene scene = samples::soft_body(12, 12, 0.05, 0.3);
  scene.loading.duration = 10;
  scene.loading.initial_velocity_y = -1;
  scene.motion.bottom = mpm::Edge::smooth_wall;
  scene.motion.scheme = mpm::Scheme::usl;
  scene.cfl = 1;
  scene.local_damping = 0.99;
  scene.history_rows = 1000;
  const std::string text = complaint(scene, mpm::plan(scene));
  EXPECT_THAT(text, HasSubstr("the point of pixel (row "));
  EXPECT_THAT(text, HasSubstr("), soft"));
  EXPECT_THAT(text, HasSubstr("try a smaller solver.cfl"));
}

/// One row of cells between the platens, so that all of it is strained alike, and breaks.
mpm::Scene low_block(mpm::Kinematics kinematics) {
  mpm::Scene scene = samples::mortar_block(2, 16);
  scene.kinematics = kinematics;
  for (auto& phase : scene.phases)
    if (phase && phase->can_crack()) phase->tensile_scale = 1e5;
  scene.loading.stop_strain = 0.02;
  scene.loading.ramp_time = 0;  // a platen that gains speed feels the mass of what has failed
  return scene;
}

TEST(Spent, EndsTheRunWhenNothingCarriesLoadAnyMore) {
  for (const auto kinematics : {mpm::Kinematics::small_strain, mpm::Kinematics::moving}) {
    const mpm::Result result = mpm::simulate(low_block(kinematics));
    EXPECT_TRUE(result.nothing_carries);
    EXPECT_EQ(result.stop, mpm::StopReason::drop);
    EXPECT_EQ(result.tension_failures, 32);
    EXPECT_LT(result.history.back().strain, 0.01);
    EXPECT_LT(std::abs(result.history.back().stress), 1e-6 * result.peak_stress);
  }
}

TEST(Spent, NotWhileAPointCarriesSomething) {
  mpm::Scene scene = low_block(mpm::Kinematics::small_strain);
  scene.damage.residual_stiffness = 1e-9;
  EXPECT_FALSE(mpm::simulate(scene).nothing_carries);
  scene.damage.residual_stiffness = 0;
  scene.damage.crack_closure = mpm::CrackClosure::unilateral;
  EXPECT_FALSE(mpm::simulate(scene).nothing_carries);
  scene.damage.crack_closure = mpm::CrackClosure::off;
  scene.labels(0, 3) = samples::aggregate;
  const mpm::Result result = mpm::simulate(scene);
  EXPECT_FALSE(result.nothing_carries);
  EXPECT_EQ(result.stop, mpm::StopReason::strain);
}

TEST(Spent, ARunInFlightGoesOn) {
  mpm::Scene scene = samples::soft_body(8, 8, 0.05);
  scene.phases[samples::soft]->tensile_scale = 1e-3;
  scene.loading.initial_velocity_y = -1;
  scene.loading.duration = 0.02;
  scene.motion.bottom = mpm::Edge::smooth_wall;
  const mpm::Result result = mpm::simulate(scene);
  EXPECT_EQ(result.stop, mpm::StopReason::time);
  EXPECT_FALSE(result.nothing_carries);
}

std::ptrdiff_t rows_up_to_the_peak(const mpm::Result& result) {
  return std::count_if(result.history.begin(), result.history.end(),
                       [&](const mpm::HistoryRow& row) { return row.strain <= result.peak_strain; });
}

TEST(Rows, LieCloseUpToThePeakWhateverTheStopStrain) {
  mpm::Scene scene = samples::pulled(samples::small_concrete(20, 20));
  scene.loading.stop_drop = 0.5;
  scene.history_rows = 100;
  for (const double stop_strain : {1e-3, 2e-2}) {
    scene.loading.stop_strain = stop_strain;
    const mpm::Result result = mpm::simulate(scene);
    ASSERT_EQ(result.stop, mpm::StopReason::drop);
    EXPECT_GE(rows_up_to_the_peak(result), 20) << stop_strain;
    EXPECT_LE(result.history.size(), 200U) << stop_strain;
  }
}

TEST(NextFrame, IsAWholeNumberOrCloserFarBeforeTheEnd) {
  EXPECT_EQ(mpm::next_frame(40, 0, 0), 1);
  EXPECT_EQ(mpm::next_frame(40, 0, 0.3), 13);
  EXPECT_EQ(mpm::next_frame(40, 0.3, 0), 1) << "the end is not far";
  EXPECT_DOUBLE_EQ(mpm::next_frame(40, 0.01, 0), 0.05);
  EXPECT_DOUBLE_EQ(mpm::next_frame(40, 0.01, 0.02), 0.9);
  EXPECT_EQ(mpm::next_frame(40, 0.01, 0.25), 11);
}

TEST(Frames, ShowTheFailureOfARunThatEndsLongBeforeItsStopStrain) {
  mpm::Scene scene = samples::pulled(samples::small_concrete(20, 20));
  scene.loading.stop_drop = 0.5;
  scene.loading.stop_strain = 2e-2;
  scene.frames = 40;
  std::vector<double> strains;
  const mpm::Result result =
      mpm::simulate(scene, {.frames = [&](const mpm::Frame& frame) { strains.push_back(frame.strain); }});
  ASSERT_EQ(result.stop, mpm::StopReason::drop);
  EXPECT_GE(std::count_if(strains.begin(), strains.end(),
                          [&](double strain) { return strain <= result.peak_strain; }),
            8);
  EXPECT_LE(strains.size(), 80U);
}

TEST(Rows, AreThoseOfThePlanWhereNothingCanFail) {
  const mpm::Scene scene = samples::unbreakable(samples::mortar_block(20, 20));
  EXPECT_EQ(mpm::early_strain(scene), 0);
  const mpm::Plan plan = mpm::plan(scene);
  EXPECT_EQ(mpm::steps_to_next_row(scene, plan, 0, 1e-5), plan.steps_per_row);
}

}  // namespace run_history_test
