#include "apps/run/frame_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

#include "libmpm/scene/error.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace frame_folder_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

class FrameFolder : public testing::Test {
 protected:
  FrameFolder() {
    scene_.labels.setConstant(2, 2, 0);
    scene_.pixel_size = 1e-3;
    scene_.phases.emplace_back(mpm::concrete_phases().front());
  }

  static mpm::Frame frame_at(double time, std::size_t points) {
    mpm::Frame frame;
    frame.time = time;
    frame.points.resize(points);
    return frame;
  }
  /// Adds frames of 4, 3, 2 ... points to an earlier run's folder.
  void write(int frames) {
    app::FrameFolder folder(run_, scene_);
    for (int i = 0; i < frames; ++i) folder.add(frame_at(1e-6 * i, static_cast<std::size_t>(4 - i)));
    EXPECT_EQ(folder.count(), frames);
    EXPECT_EQ(folder.series(), run_ / "frames.hdf.series");
  }
  std::set<std::string> names() const {
    std::set<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(run_))
      found.insert(fs::relative(entry.path(), run_).string());
    return found;
  }

  mpm::Scene scene_;
  test::TemporaryFolder folder_;
  fs::path run_ = folder_ / "";
};

TEST_F(FrameFolder, IsCompleteAfterEveryFrame) {
  app::FrameFolder folder(run_, scene_);
  EXPECT_TRUE(names().empty()) << "without a frame there is nothing";
  for (std::size_t i = 0; i < 3; ++i) {
    folder.add(frame_at(1e-6 * static_cast<double>(i), 4 - i));
    const auto list = nlohmann::json::parse(test::read_text((run_ / "frames.hdf.series").string()))["files"];
    ASSERT_EQ(list.size(), i + 1);
    for (const auto& file : list) EXPECT_TRUE(fs::exists(run_ / file["name"].get<std::string>()));
    const std::string xdmf = test::read_text((run_ / "frames.xdmf").string());
    EXPECT_THAT(xdmf, testing::HasSubstr(list.back()["name"].get<std::string>() + ":/VTKHDF/Points"));
    EXPECT_THAT(xdmf, testing::HasSubstr("NumberOfElements=\"" + std::to_string(4 - i) + "\""));
  }
}

TEST_F(FrameFolder, LeavesNoFrameOfAnEarlierRunBehind) {
  write(3);
  fs::create_directory(run_ / "frames" / "mine");
  test::write_text((run_ / "frames" / "p_notes.txt").string(), "mine");
  write(1);
  EXPECT_EQ(names(), (std::set<std::string>{"frames", "frames/mine", "frames/p_notes.txt",
                                            "frames/p_000000.hdf", "frames.hdf.series", "frames.xdmf"}));
}

TEST_F(FrameFolder, GoesOnBehindTheFramesThatWereTaken) {
  write(4);
  const std::string list = test::read_text((run_ / "frames.hdf.series").string());
  const std::string xdmf = test::read_text((run_ / "frames.xdmf").string());
  {
    app::FrameFolder folder(run_, scene_, {{0.0, 4}, {1e-6, 3}});
    EXPECT_EQ(names(), (std::set<std::string>{"frames", "frames/p_000000.hdf", "frames/p_000001.hdf",
                                              "frames.hdf.series", "frames.xdmf"}));
    const auto kept = nlohmann::json::parse(test::read_text((run_ / "frames.hdf.series").string()));
    EXPECT_EQ(kept["files"].size(), 2U);
    folder.add(frame_at(2e-6, 2));
    folder.add(frame_at(3e-6, 1));
    EXPECT_EQ(folder.count(), 4);
  }
  EXPECT_EQ(test::read_text((run_ / "frames.hdf.series").string()), list);
  EXPECT_EQ(test::read_text((run_ / "frames.xdmf").string()), xdmf);
  fs::remove(run_ / "frames" / "p_000002.hdf");
  try {
    app::FrameFolder folder(run_, scene_, {{0.0, 4}, {1e-6, 3}, {2e-6, 2}});
    ADD_FAILURE() << "a frame is lost";
  } catch (const mpm::FileError& error) {
    EXPECT_EQ(error.field, (run_ / "frames" / "p_000002.hdf").string());
  }
  EXPECT_TRUE(fs::exists(run_ / "frames" / "p_000003.hdf")) << "nothing is removed in vain";
}

TEST_F(FrameFolder, GoesOnBehindAFrameThatTheDiskDidNotTake) {
  {
    app::FrameFolder folder(run_, scene_);
    EXPECT_TRUE(folder.add(frame_at(0, 4)));
    fs::create_directories(run_ / "frames" / "p_000001.hdf" / "in the way");
    EXPECT_FALSE(folder.add(frame_at(1e-6, 3)));
    fs::remove_all(run_ / "frames" / "p_000001.hdf");
  }
  app::FrameFolder folder(run_, scene_, {{0.0, 4}, {1e-6, 3}});
  EXPECT_TRUE(folder.add(frame_at(2e-6, 2)));
  EXPECT_TRUE(fs::exists(run_ / "frames" / "p_000002.hdf"));
  EXPECT_EQ(folder.count(), 2);
  ASSERT_TRUE(folder.failure());
  EXPECT_EQ(folder.failure()->field, (run_ / "frames" / "p_000001.hdf").string());
  EXPECT_THAT(folder.failure()->what(), testing::EndsWith("; 1 of 3 frames are missing"));
}

TEST_F(FrameFolder, IsGoneWhenTheNextRunHasNoFrames) {
  write(3);
  write(0);
  EXPECT_TRUE(names().empty());
}

TEST_F(FrameFolder, ListsTheFramesOfARunByTheirNumber) {
  EXPECT_TRUE(app::frames_of(run_).empty());
  write(3);
  const fs::path frames = run_ / "frames";
  for (const char* name : {"p_1000000.hdf", "p_000010.hdf", "p_notes.txt", "p_999999.hdf"})
    test::write_text((frames / name).string(), "");
  EXPECT_THAT(app::frames_of(run_), testing::ElementsAre(frames / "p_000000.hdf", frames / "p_000001.hdf",
                                                         frames / "p_000002.hdf", frames / "p_000010.hdf",
                                                         frames / "p_999999.hdf", frames / "p_1000000.hdf"));
}

TEST_F(FrameFolder, LeavesOutWhatTheDiskDoesNotTakeAndGoesOn) {
  app::FrameFolder folder(run_, scene_);
  EXPECT_TRUE(folder.add(frame_at(0, 4)));
  EXPECT_FALSE(folder.failure());
  for (const char* name : {"p_000001.hdf", "p_000002.hdf"}) {
    fs::create_directories(run_ / "frames" / name / "in the way");
    EXPECT_FALSE(folder.add(frame_at(1e-6, 4)));
  }
  EXPECT_TRUE(folder.add(frame_at(2e-6, 4))) << "there is space again";
  EXPECT_EQ(folder.count(), 2);
  ASSERT_TRUE(folder.failure());
  EXPECT_EQ(folder.failure()->field, (run_ / "frames" / "p_000001.hdf").string());
  EXPECT_THAT(folder.failure()->what(), testing::HasSubstr("Is a directory"));
  EXPECT_THAT(folder.failure()->what(), testing::EndsWith("; 2 of 4 frames are missing"));
  const auto list = nlohmann::json::parse(test::read_text((run_ / "frames.hdf.series").string()))["files"];
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[1]["name"], "frames/p_000003.hdf");
}

TEST_F(FrameFolder, NamesTheListThatCannotBeWritten) {
  app::FrameFolder folder(run_, scene_);
  fs::create_directories(run_ / "frames.xdmf" / "in the way");
  EXPECT_FALSE(folder.add(frame_at(0, 4)));
  EXPECT_EQ(folder.count(), 1);
  ASSERT_TRUE(folder.failure());
  EXPECT_EQ(folder.failure()->field, (run_ / "frames.xdmf").string());
  EXPECT_THAT(folder.failure()->what(), testing::Not(testing::HasSubstr("missing")));
}

TEST_F(FrameFolder, NamesAFolderThatCannotBeMade) {
  test::write_text((run_ / "frames").string(), "a file");
  app::FrameFolder folder(run_, scene_);
  EXPECT_FALSE(folder.add(frame_at(0, 4)));
  ASSERT_TRUE(folder.failure());
  EXPECT_EQ(folder.failure()->field, (run_ / "frames").string());
  EXPECT_THAT(folder.failure()->what(), testing::HasSubstr("cannot be created"));
}

TEST_F(FrameFolder, NamesWhatCannotBeRemoved) {
  const auto message = [&](const fs::path& path, const auto& act) {
    try {
      act();
      ADD_FAILURE() << path << " was taken";
    } catch (const mpm::FileError& error) {
      EXPECT_EQ(error.field, path.string());
      return std::string(error.what());
    }
    return std::string();
  };
  fs::create_directories(run_ / "frames.xdmf" / "full");
  EXPECT_THAT(message(run_ / "frames.xdmf", [&] { write(1); }), testing::HasSubstr("cannot be removed"));
}

TEST(FrameName, SortsByNumberAndIsKnownAgain) {
  EXPECT_EQ(output::frame_name(0), "p_000000.hdf");
  EXPECT_EQ(output::frame_name(12), "p_000012.hdf");
  EXPECT_EQ(output::frame_name(1234567), "p_1234567.hdf");
  for (const int number : {0, 12, 1234567}) EXPECT_TRUE(output::is_frame_name(output::frame_name(number)));
  for (const char* other : {"", "p_.hdf", "p_00012.hdf", "p_00001a.hdf", "q_000012.hdf", "p_000012.hdf5",
                            "p_000012.h5", "my_p_000012.hdf"})
    EXPECT_FALSE(output::is_frame_name(other)) << other;
}

TEST(FrameSeries, IsParaViewsListOfFilesAndTimes) {
  output::FrameSeries series;
  EXPECT_EQ(nlohmann::json::parse(series.text())["files"].size(), 0U);
  series.add({"frames/p_000000.hdf", 0, 5});
  series.add({"frames/p_000001.hdf", 1.0 / 3e5, 4});
  const auto list = nlohmann::json::parse(series.text());
  EXPECT_EQ(list["file-series-version"], "1.0");
  ASSERT_EQ(list["files"].size(), 2U);
  EXPECT_EQ(list["files"][1]["name"], "frames/p_000001.hdf");
  EXPECT_EQ(list["files"][1]["time"].get<double>(), 1.0 / 3e5) << "to the last digit";
}

// What readers make of it is tested with VTK's; this is what they are known to stumble over.
TEST(FrameXdmf, GivesEveryVertexItsPoint) {
  output::FrameXdmf xdmf;
  xdmf.add({"frames/p_000000.hdf", 0.5, 5});
  EXPECT_THAT(xdmf.text(), HasSubstr("CollectionType=\"Temporal\""));
  EXPECT_THAT(xdmf.text(), HasSubstr("<Time Value=\"0.5\"/>"));
  EXPECT_THAT(xdmf.text(),
              HasSubstr("<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"5\" NodesPerElement=\"1\">"
                        "<DataItem Dimensions=\"5 1\" NumberType=\"Int\" Precision=\"8\" Format=\"HDF\">"
                        "frames/p_000000.hdf:/VTKHDF/Connectivity</DataItem></Topology>"));
}

TEST(FrameXdmf, LeavesOutAFrameWithoutPoints) {
  output::FrameXdmf xdmf;
  xdmf.add({"frames/p_000000.hdf", 0, 5});
  const std::string before = xdmf.text();
  xdmf.add({"frames/p_000001.hdf", 1, 0});
  EXPECT_EQ(xdmf.text(), before);
}

}  // namespace frame_folder_test
