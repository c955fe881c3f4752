#include "apps/run/run_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "apps/drawing/damage_picture.hpp"
#include "apps/drawing/deformed_picture.hpp"
#include "apps/drawing/picture_parts.hpp"
#include "apps/system/files.hpp"
#include "libmpm/files/result_file.hpp"
#include "libmpm/scene/error.hpp"
#include "specimen/body/error.hpp"
#include "specimen/picture/picture.hpp"
#include "tests/apps/fake_run.hpp"

namespace run_folder_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

class RunFolder : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(parent_); }
  void TearDown() override {
    fs::permissions(parent_, fs::perms::owner_all);
    fs::remove_all(parent_);
  }

  std::set<std::string> names() const {
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_)) found.insert(entry.path().filename());
    return found;
  }
  std::string content(const char* name) const {
    std::ifstream in(folder_ / name, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }
  specimen::Raster<specimen::Rgb> picture(const char* name) const {
    const specimen::Picture read = specimen::read_picture((folder_ / name).string());
    if (read.gray.empty()) return read.colour;
    specimen::Raster<specimen::Rgb> colour(read.gray.rows, read.gray.cols);
    for (std::size_t i = 0; i < colour.size(); ++i) {
      const auto level = static_cast<std::uint8_t>(read.gray.data[i]);
      colour.data[i] = {level, level, level};
    }
    return colour;
  }

  fs::path parent_ = fs::path(testing::TempDir()) / ("run_folder_" + std::to_string(::getpid()));
  fs::path folder_ = parent_ / "runs" / "first";
};

TEST_F(RunFolder, HoldsTheseFilesAndNoOthers) {
  const FakeRun run = tension_run(30);
  write_run(folder_, run.record());
  EXPECT_EQ(names(), (std::set<std::string>{"curve.csv",
                                            "curve.png",
                                            "report.html",
                                            "result.h5",
                                            "scene.toml",
                                            "specimen.h5",
                                            "specimen.png",
                                            "summary.json",
                                            "damage_025.png",
                                            "damage_050.png",
                                            "damage_075.png",
                                            "damage_100.png",
                                            "damage_125.png",
                                            "damage_150.png",
                                            "damage_025_colour.png",
                                            "damage_050_colour.png",
                                            "damage_075_colour.png",
                                            "damage_100_colour.png",
                                            "damage_125_colour.png",
                                            "damage_150_colour.png"}));
}

TEST_F(RunFolder, HoldsWhatItWasGiven) {
  const FakeRun run = tension_run(30);
  write_run(folder_, run.record());
  EXPECT_EQ(content("scene.toml"), run.scene_toml);
  EXPECT_EQ(nlohmann::json::parse(content("summary.json")), summary(run.record()));
  EXPECT_EQ(mpm::read_result(folder_ / "result.h5").history.size(), run.result.history.size());
  EXPECT_EQ(mpm::read_scene_text(folder_ / "result.h5"), run.scene_toml);

  const auto curve = picture("curve.png");
  EXPECT_EQ(curve.cols, 1600);
  EXPECT_EQ(curve.rows, 1000);
  std::set<int> shades;
  for (const specimen::Rgb& pixel : curve.data) shades.insert(pixel.r);
  EXPECT_GT(shades.size(), 20U) << "words and lines are anti-aliased";
}

TEST_F(RunFolder, DrawsPicturesMagnifiedByWholeFactors) {
  const FakeRun run = tension_run(30);
  write_run(folder_, run.record());
  EXPECT_EQ(picture("specimen.png"), output::magnified(specimen::preview(run.specimen.mask), 20));
  for (const auto& [name, palette] : {std::pair{"damage_100.png", output::grey_palette()},
                                      std::pair{"damage_100_colour.png", output::colour_palette()}})
    EXPECT_EQ(picture(name),
              output::magnified(output::damage_picture(run.specimen.mask, run.result, 144e-6, palette), 20));
  EXPECT_NEAR(specimen::read_picture((folder_ / "specimen.png").string()).pixel_size, 0.005 / 20, 1e-7);
}

TEST_F(RunFolder, LeavesNoPictureOfAnEarlierRunBehind) {
  const FakeRun long_run = tension_run(30, 200);
  const FakeRun short_run = tension_run(30, 60);
  write_run(folder_, long_run.record());
  std::ofstream(folder_ / "damage_notes.txt") << "mine";
  write_run(folder_, short_run.record());
  EXPECT_FALSE(names().contains("damage_075.png"));
  EXPECT_FALSE(names().contains("damage_150_colour.png"));
  EXPECT_TRUE(names().contains("damage_050.png"));
  EXPECT_TRUE(names().contains("damage_notes.txt"));
}

TEST_F(RunFolder, LeavesNoMapThatWasExportedFromAnEarlierRunBehind) {
  for (const char* name : {"damage.tif", "failure_strain.tif"}) std::ofstream(folder_ / name) << "of before";
  write_run(folder_, tension_run(30).record());
  EXPECT_FALSE(names().contains("damage.tif"));
  EXPECT_FALSE(names().contains("failure_strain.tif"));
}

TEST_F(RunFolder, HoldsTheEndOfMovingPointsAndNoneOfAnEarlierRun) {
  const FakeRun moving = impact_run(30);
  write_run(folder_, moving.record());
  for (const auto& [name, palette] : {std::pair{"deformed.png", output::grey_palette()},
                                      std::pair{"deformed_colour.png", output::colour_palette()}})
    EXPECT_EQ(picture(name), output::deformed_picture(moving.specimen.mask, moving.result, palette, 20));
  const FakeRun still = tension_run(30);
  write_run(folder_, still.record());
  EXPECT_FALSE(names().contains("deformed.png"));
  EXPECT_FALSE(names().contains("deformed_colour.png"));
}

TEST_F(RunFolder, WritesTheSameBytesForTheSameRun) {
  const FakeRun run = compression_run(30);
  write_run(folder_, run.record());
  std::vector<std::string> first;
  for (const std::string& name : names()) first.push_back(content(name.c_str()));
  write_run(folder_, run.record());
  std::vector<std::string> second;
  for (const std::string& name : names()) second.push_back(content(name.c_str()));
  EXPECT_EQ(first, second);
}

TEST_F(RunFolder, TakesARunThatBrokeOffAtOnce) {
  const FakeRun run = still_run({"12", "32"});
  write_run(folder_, run.record());
  EXPECT_TRUE(names().contains("report.html"));
  EXPECT_TRUE(names().contains("curve.png"));
}

TEST_F(RunFolder, TakesATitleThatIsNoUtf8) {
  const FakeRun run = tension_run(30);
  RunRecord record = run.record();
  record.title = "\xff\xfe";
  write_run(folder_, record);
  EXPECT_EQ(nlohmann::json::parse(content("summary.json"))["title"], "\uFFFD\uFFFD");
}

TEST_F(RunFolder, NamesAFolderThatCannotBeMade) {
  std::ofstream(parent_ / "runs") << "a file";
  const FakeRun run = tension_run(30);
  try {
    write_run(folder_, run.record());
    FAIL() << "a file was taken for a folder";
  } catch (const mpm::FileError& error) {
    EXPECT_EQ(error.field, folder_.string());
    EXPECT_THAT(error.what(), HasSubstr("cannot be created: Not a directory"));
  }
}

TEST_F(RunFolder, NamesTheFilesThatCannotBeWrittenAndWritesAllOthers) {
  const FakeRun run = impact_run(8);
  write_run(folder_, run.record());
  const std::set<std::string> all = names();
  for (const std::string& blocked : all) {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / blocked / "folder");
    try {
      write_run(folder_, run.record());
      ADD_FAILURE() << blocked << ": a folder was replaced by a file";
    } catch (const NotWritten& missing) {
      ASSERT_EQ(missing.files.size(), 1U) << blocked;
      EXPECT_EQ(missing.files[0].field, (folder_ / blocked).string());
    }
    EXPECT_EQ(names(), all);
    for (const std::string& name : all) EXPECT_EQ(fs::is_directory(folder_ / name), name == blocked);
  }
}

/// While it lives root has the rights of nobody, who may not write anywhere.
class AsNobody {
 public:
  AsNobody() { change(nobody); }
  ~AsNobody() { change(0); }
  AsNobody(const AsNobody&) = delete;
  AsNobody& operator=(const AsNobody&) = delete;

 private:
  static constexpr uid_t nobody = 65534;
  void change(uid_t user) const {
    if (is_root_ && ::seteuid(user) != 0) ADD_FAILURE() << "cannot act as user " << user;
  }
  const bool is_root_ = ::geteuid() == 0;
};

TEST_F(RunFolder, RespectsAFolderThatMayOnlyBeRead) {
  fs::create_directories(folder_);
  fs::permissions(folder_, fs::perms(0555));
  const FakeRun run = tension_run(30);
  const AsNobody nobody;
  EXPECT_THROW(write_run(folder_, run.record()), mpm::FileError);
}

}  // namespace run_folder_test
