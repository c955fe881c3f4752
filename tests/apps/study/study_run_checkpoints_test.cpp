#include "apps/study/study_run.hpp"

#include <gtest/gtest.h>
#include <fstream>

#include "apps/job/job.hpp"
#include "apps/job/specimen_source.hpp"
#include "apps/study/study_members.hpp"
#include "libmpm/files/result_file.hpp"
#include "tests/apps/small_study.hpp"

namespace study_run_checkpoints_test {

namespace fs = std::filesystem;
using namespace app;

class MemberCheckpointsTest : public testing::Test {
 protected:
  MemberCheckpointsTest() {
    const Study study = test::small_study(files_, "seeds = [3]\n");
    const Settings settings = *list_members(study).front().settings;
    scene_ = build_scene(prepare_specimen(settings).specimen, settings);
  }

  mpm::Result run(int rows, const char* scene_text = "scene") {
    int seen = 0;
    return MemberCheckpoints(folder_, scene_text).run(scene_, [&](const mpm::Progress& progress) {
      if (seen == 0) first_ = progress.row.strain;
      return ++seen < rows;
    });
  }
  [[nodiscard]] std::vector<fs::path> checkpoints() const {
    std::vector<fs::path> found;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder_ / "checkpoints", none))
      found.push_back(entry.path());
    return found;
  }
  static std::string curve(const mpm::Result& result) {
    std::ostringstream text;
    text.precision(17);
    for (const mpm::HistoryRow& row : result.history) text << row.strain << ' ' << row.stress << '\n';
    return text.str();
  }

  test::TemporaryFolder files_;
  fs::path folder_ = files_ / "member";
  mpm::Scene scene_;
  double first_ = 0;  ///< strain of the first row that the last run came to [-]
};

constexpr int all = 1'000'000;

TEST_F(MemberCheckpointsTest, ARunThatWasStoppedGoesOnWithTheSameBits) {
  const mpm::Result whole = mpm::simulate(scene_);
  EXPECT_EQ(run(10).stop, mpm::StopReason::interrupted);
  ASSERT_EQ(checkpoints().size(), 1U);
  EXPECT_EQ(curve(run(all)), curve(whole));
  EXPECT_GT(first_, whole.history[5].strain) << "it began anew";
}

TEST_F(MemberCheckpointsTest, OfAnotherSceneAreOfNoUse) {
  const mpm::Result whole = mpm::simulate(scene_);
  run(10, "another scene");
  EXPECT_EQ(curve(run(all)), curve(whole));
  EXPECT_EQ(first_, whole.history[0].strain);
  EXPECT_TRUE(checkpoints().empty());
}

TEST_F(MemberCheckpointsTest, ThatAreDamagedAreOfNoUse) {
  const mpm::Result whole = mpm::simulate(scene_);
  run(10);
  std::ofstream(checkpoints().front(), std::ios::app) << "x";
  EXPECT_EQ(curve(run(all)), curve(whole));
  EXPECT_EQ(first_, whole.history[0].strain);
}

TEST_F(MemberCheckpointsTest, OfAnotherSpecimenAreOfNoUse) {
  run(10);
  scene_.labels(0, 0) = scene_.labels(0, 0) == 1 ? 2 : 1;
  const mpm::Result whole = mpm::simulate(scene_);
  EXPECT_EQ(curve(run(all)), curve(whole));
  EXPECT_EQ(first_, whole.history[0].strain);
}

TEST_F(MemberCheckpointsTest, ThatCannotBeWrittenStopNothing) {
  test::write_text(folder_.string(), "a file where the folder should be");
  EXPECT_EQ(run(10).stop, mpm::StopReason::interrupted);
  EXPECT_EQ(curve(run(all)), curve(mpm::simulate(scene_)));
}

TEST_F(MemberCheckpointsTest, GoOnceTheResultIsKept) {
  run(10);
  MemberCheckpoints(folder_, "scene").remove();
  EXPECT_FALSE(fs::exists(folder_));
}

}  // namespace study_run_checkpoints_test
