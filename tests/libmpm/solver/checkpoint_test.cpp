#include "libmpm/solver/checkpoint.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <optional>

#include "libmpm/kernels/instruction_set.hpp"
#include "libmpm/run/simulate.hpp"
#include "libmpm/scene/error.hpp"
#include "tests/libmpm/kinds_of_runs.hpp"

namespace checkpoint_test {

using mpm::Checkpoint;
using mpm::Frame;
using mpm::Result;
using mpm::Scene;

/// What a run left, or what went wrong with it.
struct Part {
  Result result;
  std::string divergence;
  std::vector<Frame> frames;
  std::optional<Checkpoint> checkpoint;  ///< where it was interrupted
};

/// From the start, or from where `from` was interrupted.   @param rows  to go at most; < 0 = to the end.
Part go(Scene scene, int threads, int rows, const Part* from = nullptr) {
  scene.threads = threads;
  Part run;
  if (from != nullptr) {  // as files are: those that the run has lent, and none of its end
    run.frames = from->frames;
    run.frames.resize(from->checkpoint->frames.size());
  }
  mpm::RunHooks hooks;
  hooks.observer = [&](const mpm::Progress&) { return --rows != 0; };
  hooks.frames = [&](const Frame& frame) { run.frames.push_back(frame); };
  hooks.checkpoints.sink = [&](const Checkpoint& checkpoint) { run.checkpoint = checkpoint; };
  try {
    run.result = from != nullptr ? mpm::resume(scene, *from->checkpoint, hooks) : mpm::simulate(scene, hooks);
  } catch (const mpm::Diverged& diverged) {
    run.result = diverged.result;
    run.divergence = diverged.what();
  }
  return run;
}

/// In pieces of some rows, each on another number of threads than the one before.
Part relay(const Scene& scene, int rows) {
  Part run = go(scene, 1, rows);
  for (int piece = 1; run.checkpoint; ++piece) run = go(scene, piece % 2 == 0 ? 1 : 3, rows, &run);
  return run;
}

TEST(Checkpoint, GoesOnAsIfTheRunHadNeverStopped) {
  for (samples::Kind& kind : samples::kinds_of_runs()) {
    SCOPED_TRACE(kind.name);
    kind.scene.frames = 5;
    const Part whole = go(kind.scene, 2, -1);
    ASSERT_GT(whole.result.tension_failures + whole.result.shear_failures, 3);
    ASSERT_GT(whole.result.history.size(), 20U);
    const Part pieces = relay(kind.scene, 9);
    EXPECT_TRUE(samples::same_result(whole.result, pieces.result));
    EXPECT_EQ(whole.divergence, pieces.divergence);
    if (samples::figures)
      std::printf("%-32s %5lld steps %5lld failures %.3f s, in pieces %.3f s\n", kind.name.c_str(),
                  static_cast<long long>(whole.result.steps),
                  static_cast<long long>(whole.result.tension_failures + whole.result.shear_failures),
                  whole.result.wall_time, pieces.result.wall_time);
    EXPECT_TRUE(whole.frames == pieces.frames);
    EXPECT_FALSE(pieces.checkpoint);
  }
}

/// From every row of a run.   @return how many checkpoints there were of points that move.
int expect_as_good_after_any_row(const Scene& scene) {
  const Part whole = go(scene, 1, -1);
  int moving = 0;
  for (int rows = 1; rows < static_cast<int>(whole.result.history.size()); ++rows) {
    const Part first = go(scene, 1, rows);
    EXPECT_TRUE(first.checkpoint) << rows;
    if (!first.checkpoint) return 0;
    moving += first.checkpoint->moving ? 1 : 0;
    const Part rest = go(scene, 1, -1, &first);
    EXPECT_TRUE(samples::same_result(whole.result, rest.result)) << rows;
    EXPECT_TRUE(whole.frames == rest.frames) << rows;
  }
  return moving;
}

TEST(Checkpoint, IsAsGoodAfterAnyRow) {
  Scene scene = samples::kinds::handed_over(samples::kinds::pulled_concrete());
  scene.history_rows = 30;
  scene.frames = 4;
  const int moving = expect_as_good_after_any_row(scene);
  EXPECT_GT(moving, 5);
  EXPECT_LT(moving, 25) << "points stay on the lattice first";
  scene = samples::kinds::thrown_disc();
  scene.history_rows = 15;
  scene.frames = 4;
  ASSERT_GT(go(scene, 1, -1).result.history.back().left_points, 10);
  expect_as_good_after_any_row(scene);
}

TEST(Checkpoint, IsTheSameForAnyNumberOfThreads) {
  for (const samples::Kind& kind : samples::kinds_of_runs()) {
    const Part one = go(kind.scene, 1, 15);
    const Part three = go(kind.scene, 3, 15);
    ASSERT_TRUE(one.checkpoint && three.checkpoint) << kind.name;
    EXPECT_EQ(one.checkpoint->state, three.checkpoint->state) << kind.name;
  }
}

TEST(Checkpoint, LeavesNothingOutWhereTheSpecimenIsLost) {
  Scene scene = samples::pulled(samples::mortar_block(2, 16));
  scene.phases[samples::mortar]->tensile_scale = 1e5;
  scene.loading.stop_strain = 0.02;
  scene.loading.ramp_time = 0;
  scene.history_rows = 10000;
  const Part whole = go(scene, 1, -1);
  ASSERT_TRUE(whole.result.nothing_carries);
  const int rows = static_cast<int>(whole.result.history.size());
  ASSERT_GE(rows, 5);
  for (int row = rows - 3; row < rows - 1; ++row) {
    const Part first = go(scene, 1, row);
    ASSERT_TRUE(first.checkpoint);
    const Part rest = go(scene, 1, -1, &first);
    EXPECT_TRUE(samples::same_result(whole.result, rest.result)) << row;
  }
}

/// Pixels that touch at their corners only bear no such step.
Scene diverging_lattice() {
  Scene scene = samples::unbreakable(samples::mortar_block(40, 40));
  scene.labels.setConstant(0);
  for (int i = 0; i < 40; ++i) scene.labels(i, i) = samples::mortar;
  scene.cfl = 1;
  scene.loading.velocity = 1;
  scene.loading.stop_strain = 0.5;
  scene.history_rows = 1000000;
  return scene;
}

/// The points fly out at an edge that is closed.
Scene leaving_disc() {
  Scene scene = samples::kinds::thrown_disc();
  scene.motion.left = scene.motion.right = mpm::Edge::closed;
  scene.loading.duration = 0.05;
  return scene;
}

TEST(Checkpoint, DivergesAsTheWholeRunDoes) {
  for (const Scene& scene : {diverging_lattice(), leaving_disc()}) {
    const Part whole = go(scene, 1, -1);
    ASSERT_NE(whole.divergence, "");
    const int rows = static_cast<int>(whole.result.history.size()) - 2;
    ASSERT_GT(rows, 0);
    const Part first = go(scene, 1, rows);
    ASSERT_TRUE(first.checkpoint);
    const Part rest = go(scene, 3, -1, &first);
    EXPECT_EQ(rest.divergence, whole.divergence);
    EXPECT_TRUE(samples::same_result(whole.result, rest.result));
  }
}

TEST(Checkpoint, CountsTheTimeOfAllParts) {
  const Scene scene = samples::kinds::pulled_concrete();
  Part first = go(scene, 1, 10);
  EXPECT_GT(first.checkpoint->wall_time, 0);
  EXPECT_LE(first.checkpoint->wall_time, first.result.wall_time);
  EXPECT_NEAR(first.checkpoint->fraction, first.result.history.back().strain / scene.loading.stop_strain,
              1e-12);
  EXPECT_EQ(first.checkpoint->step, first.result.steps);
  first.checkpoint->wall_time = 1000;
  double told = 0;
  const Result rest = mpm::resume(scene, *first.checkpoint, {.observer = [&](const mpm::Progress& progress) {
                                    told = progress.wall_time;
                                    return true;
                                  }});
  EXPECT_GT(told, 1000);
  EXPECT_GE(rest.wall_time, told);
  EXPECT_LT(rest.wall_time, 1100);
}

TEST(Checkpoint, ComesInTimeHoweverLongTheLastOneTook) {
  const Scene scene = samples::kinds::pulled_concrete();
  const auto count = [&](double every, double pause) {
    int kept = 0;
    mpm::RunHooks hooks;
    hooks.checkpoints = {
        [&](const Checkpoint&) {
          ++kept;
          const auto begin = std::chrono::steady_clock::now();
          while (std::chrono::steady_clock::now() - begin < std::chrono::duration<double>(pause)) {
          }
        },
        every};
    (void)mpm::simulate(scene, hooks);
    return kept;
  };
  EXPECT_EQ(count(0, 0), 0) << "on the way only where that is asked for";
  EXPECT_EQ(count(1000, 0), 0);
  EXPECT_GT(count(1e-9, 0), 0);
  EXPECT_GT(count(1e-9, 0.01), 3) << "one that was slow does not end those that follow";
}

TEST(Checkpoint, ChangesNothingInTheRun) {
  const Scene scene = samples::kinds::pulled_concrete();
  mpm::RunHooks hooks;
  hooks.checkpoints = {[](const Checkpoint&) {}, 1e-9};
  EXPECT_TRUE(samples::same_result(mpm::simulate(scene), mpm::simulate(scene, hooks)));
}

/// What resume() says of a scene and a checkpoint.
std::string complaint(const Scene& scene, const Checkpoint& checkpoint) {
  try {
    (void)mpm::resume(scene, checkpoint);
  } catch (const mpm::FileError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(Checkpoint, GoesOnWithItsOwnSceneOnly) {
  const Scene scene = samples::kinds::with_extra_points(samples::kinds::pulled_concrete());
  const Checkpoint checkpoint = *go(scene, 1, 10).checkpoint;
  const std::string cure = "; resume with the scene that the run was started with";
  const auto expect = [&](const std::string& what, const auto& change) {
    Scene other = scene;
    change(other);
    EXPECT_EQ(complaint(other, checkpoint), "checkpoint: has " + what + cure);
  };
  expect("another specimen than the scene", [](Scene& it) { it.labels(3, 4) = samples::aggregate; });
  expect("another specimen than the scene", [](Scene& it) { it.pixel_size *= 2; });
  expect("another specimen than the scene", [](Scene& it) { it.extra_points[2].x *= 1.01; });
  expect("another specimen than the scene", [](Scene& it) { it.extra_points.pop_back(); });
  expect("another precision than the scene", [](Scene& it) { it.precision = mpm::Precision::single; });
  expect("other kinematics than the scene", [](Scene& it) { it.kinematics = mpm::Kinematics::moving; });
  if (mpm::available_kernels().size() > 1)
    expect("the instruction set " + checkpoint.instruction_set,
           [](Scene& it) { it.instruction_set = "baseline"; });
  Checkpoint foreign = checkpoint;
  foreign.instruction_set = "avx1024";
  EXPECT_THAT(complaint(scene, foreign), testing::HasSubstr("needs a processor that supports avx1024; "));
}

// Whoever changes a checkpoint can make its digest right again: then nothing but an error may come of it.
TEST(Checkpoint, RefusesAStateThatCannotBe) {
  for (const samples::Kind& kind : samples::kinds_of_runs()) {
    const Checkpoint good = *go(kind.scene, 1, 25).checkpoint;
    for (std::size_t i = 0; i < 60; ++i) {
      Checkpoint cut = good;
      cut.state.resize(good.state.size() * i / 60);
      EXPECT_THAT(complaint(kind.scene, cut), testing::StartsWith("checkpoint: holds ")) << kind.name;
    }
    Checkpoint longer = good;
    longer.state += '\0';
    EXPECT_THAT(complaint(kind.scene, longer), testing::HasSubstr("holds bytes after its end"));
    Checkpoint empty = good;
    empty.moving = !good.moving;
    EXPECT_NE(complaint(kind.scene, empty), "nothing") << kind.name;
  }
}

TEST(Checkpoint, NoChangedByteTearsTheProgramDown) {
  for (const char* name : {"extra points", "hand-over", "thrown"}) {
    for (const samples::Kind& kind : samples::kinds_of_runs()) {
      if (kind.name.rfind(name, 0) != 0) continue;
      const Checkpoint good = *go(kind.scene, 1, 25).checkpoint;
      for (std::size_t i = 0; i < 150; ++i) {
        Checkpoint bad = good;
        char& byte = bad.state[(i * i * 131 + 7 * i) % bad.state.size()];
        byte = static_cast<char>(byte ^ (i % 2 == 0 ? 0x80 : 0x41));
        try {
          int rows = 2;
          (void)mpm::resume(kind.scene, bad, {.observer = [&](const mpm::Progress&) { return --rows > 0; }});
        } catch (const mpm::FileError&) {  // it was seen
        } catch (const mpm::Diverged&) {   // it was not, and is no motion
        }
      }
      break;
    }
  }
}

std::string hexadecimal(const std::string& digest) {
  std::string text;
  for (const char byte : digest) {
    char two[3];
    std::snprintf(two, sizeof two, "%02x", static_cast<unsigned>(static_cast<unsigned char>(byte)));
    text += two;
  }
  return text;
}

// FIPS 180-4 and its examples.
TEST(Sha256, GivesTheKnownDigests) {
  EXPECT_EQ(hexadecimal(mpm::Sha256().digest()),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(hexadecimal(mpm::Sha256().add("abc").digest()),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Sha256, IsThatOfThePiecesTogether) {
  EXPECT_EQ(mpm::Sha256().add("a").add("").add("bc").digest(), mpm::Sha256().add("abc").digest());
}

}  // namespace checkpoint_test
