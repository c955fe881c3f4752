#include "apps/run/run_location.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "apps/command/program.hpp"
#include "apps/report/report.hpp"
#include "apps/text/complaint.hpp"
#include "libmpm/scene/error.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace run_location_test {

namespace fs = std::filesystem;

/// Works inside a folder of its own, for the default lies below the current one.
class RunLocation : public testing::Test {
 protected:
  void SetUp() override { fs::current_path(folder_ / ""); }
  void TearDown() override { fs::current_path(before_); }

  static std::string complaint_about(const fs::path& wanted) {
    try {
      (void)app::make_run_folder(wanted, "stem", false);
      return "accepted";
    } catch (const app::Rejected& rejected) {
      EXPECT_EQ(rejected.code, app::Exit::usage);
      return rejected.what();
    }
  }

 private:
  fs::path before_ = fs::current_path();
  test::TemporaryFolder folder_;
};

TEST_F(RunLocation, CountsUpWhereTheDefaultIsTaken) {
  EXPECT_EQ(app::make_run_folder("", "a", false), "runs/a");
  EXPECT_EQ(app::make_run_folder("", "a", false), "runs/a-2");
  EXPECT_EQ(app::make_run_folder("", "a", false), "runs/a-3");
  EXPECT_TRUE(fs::is_directory("runs/a-3"));
}

TEST_F(RunLocation, OverwritesTheDefaultWhenAsked) {
  fs::create_directories("runs/a");
  EXPECT_EQ(app::make_run_folder("", "a", true), "runs/a");
}

TEST_F(RunLocation, TakesAFolderThatIsNewOrEmpty) {
  EXPECT_EQ(app::make_run_folder("x/y", "a", false), "x/y");
  EXPECT_EQ(app::make_run_folder("x/y", "a", false), "x/y");
}

TEST_F(RunLocation, RefusesAFolderWithSomethingInIt) {
  fs::create_directories("x");
  test::write_text("x/note", "mine");
  EXPECT_EQ(complaint_about("x"), "-o: x; is not empty; choose another folder, or add --overwrite");
  EXPECT_EQ(app::make_run_folder("x", "a", true), "x");
}

TEST_F(RunLocation, RefusesAFile) {
  test::write_text("x", "mine");
  EXPECT_EQ(complaint_about("x"), "-o: x; is a file; must be a folder; choose another name");
}

TEST_F(RunLocation, AFolderThatCannotBeMadeIsAMatterOfTheDisk) {
  test::write_text("x", "mine");
  try {
    (void)app::make_run_folder("x/y", "a", false);
    FAIL();
  } catch (const app::Rejected& rejected) {
    EXPECT_EQ(rejected.code, app::Exit::io);
    EXPECT_STREQ(rejected.what(), "x/y: Not a directory; must be a folder that can be made");
  }
}

/// A folder that holds a run of a small specimen.
class RunReader : public testing::Test {
 protected:
  void SetUp() override {
    std::ostringstream out, err;
    app::Console console{out, err, false, false, {}};
    test::write_text(
        folder_ / "scene.toml",
        "[generate]\nwidth = \"20 mm\"\nheight = \"20 mm\"\npixel_size = \"1 mm\"\nfraction = 0.3\n"
        "d_min = \"4 mm\"\nd_max = \"8 mm\"\n[loading]\nstop_strain = 20e-6\n");
    ASSERT_EQ(
        app::run_program({"simulate", folder_ / "scene.toml", "--title", "A small one", "-o", run_}, console),
        app::Exit::ok)
        << err.str();
  }

  test::TemporaryFolder folder_;
  const std::string run_ = folder_ / "run";
};

TEST_F(RunReader, GivesBackWhatWasWritten) {
  const app::ReadRun run = app::read_run(run_);
  EXPECT_EQ(run.settings.title, "A small one");
  EXPECT_EQ(run.specimen.mask.labels.rows, 20);
  EXPECT_EQ(run.scene.labels.rows(), 20);
  EXPECT_DOUBLE_EQ(run.scene.loading.stop_strain, 20e-6);
  EXPECT_NEAR(run.result.history.back().strain, 20e-6, 1e-6);
  // The page of a run that was read back is the page that was written.
  std::ifstream in(run_ + "/report.html");
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(output::report_html(run.record()), page);
}

TEST_F(RunReader, RefusesAFolderWhoseFilesDoNotBelongTogether) {
  fs::remove(fs::path(run_) / "specimen.h5");
  std::ostringstream out, err;
  app::Console console{out, err, false, false, {}};
  ASSERT_EQ(app::run_program(
                {"generate", "--width", "30 mm", "--height", "30 mm", "--pixel-size", "1 mm", "--fraction",
                 "0.3", "--d-min", "4 mm", "--d-max", "8 mm", "-o", run_ + "/specimen.h5"},
                console),
            app::Exit::ok)
      << err.str();
  EXPECT_THROW((void)app::read_run(run_), app::Rejected);
}

TEST_F(RunReader, RefusesWhatIsNoRun) {
  EXPECT_THROW((void)app::read_run(run_ + "/result.h5"), app::Rejected);
  fs::remove(fs::path(run_) / "result.h5");
  EXPECT_THROW((void)app::read_run(run_), mpm::FileError);
}

}  // namespace run_location_test
