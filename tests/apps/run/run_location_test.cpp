#include "apps/run/run_location.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "apps/command/program.hpp"
#include "apps/report/report.hpp"
#include "apps/run/run_folder.hpp"
#include "apps/text/complaint.hpp"
#include "libmpm/scene/error.hpp"
#include "specimen/file/specimen_file.hpp"
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

TEST_F(RunReader, RefusesTheResultOfAnotherRun) {
  const std::string before = test::read_text(run_ + "/scene.toml");
  test::write_text(run_ + "/scene.toml", before + "# of another run\n");
  EXPECT_THROW(app::check_one_run(run_), app::Rejected);
  EXPECT_THROW((void)app::read_run(run_), app::Rejected);
  test::write_text(run_ + "/scene.toml", before);
  EXPECT_NO_THROW(app::check_one_run(run_));
  std::string summary = test::read_text(run_ + "/summary.json");
  summary.at(summary.find("\"run\": \"") + 8) = 'x';
  test::write_text(run_ + "/summary.json", summary);
  EXPECT_THROW(app::check_one_run(run_), app::Rejected);
}

TEST_F(RunReader, ARunThatBeginsAnewTakesTheOldResultsAway) {
  specimen::Specimen other = app::read_run(run_).specimen;
  other.mask.pixel_size *= 2;
  retire_results(run_, "[loading]\n", other);
  EXPECT_EQ(test::read_text(run_ + "/scene.toml"), "[loading]\n");
  EXPECT_EQ(specimen::read_specimen(run_ + "/specimen.h5").mask.pixel_size, other.mask.pixel_size);
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(run_)) files += entry.is_regular_file() ? 1 : 0;
  EXPECT_EQ(files, 2U) << "scene and specimen alone";
  fs::remove(run_ + "/scene.toml");
  retire_results(run_, "[loading]\n", other);
  EXPECT_FALSE(fs::exists(run_ + "/scene.toml")) << "there were no results";
}

class MadeAgain : public RunReader {
 protected:
  void make(const std::string& run) {
    std::ostringstream out, err;
    app::Console console{out, err, false, false, {}};
    ASSERT_EQ(app::run_program({"report", run}, console), app::Exit::ok) << err.str();
  }
};

TEST_F(MadeAgain, AreFilesThatADiskHasNotTaken) {
  const std::string page = test::read_text(run_ + "/report.html"),
                    summary = test::read_text(run_ + "/summary.json");
  for (const auto& entry : fs::directory_iterator(run_))
    if (entry.path().filename() != "result.h5") fs::remove_all(entry.path());
  make(run_);
  EXPECT_EQ(test::read_text(run_ + "/report.html"), page);
  EXPECT_EQ(test::read_text(run_ + "/summary.json"), summary);
  for (const char* name :
       {"scene.toml", "specimen.h5", "specimen.png", "curve.csv", "curve.png", "damage_100.png"})
    EXPECT_TRUE(fs::exists(fs::path(run_) / name)) << name;
  EXPECT_NO_THROW((void)app::read_run(run_));
}

/// As those of a part of the run that was interrupted, beside the result of the whole.
TEST_F(MadeAgain, AreFilesThatAreOld) {
  const std::string page = test::read_text(run_ + "/report.html");
  test::write_text(run_ + "/report.html", "<p>half a run</p>");
  make(run_ + "/result.h5");
  EXPECT_EQ(test::read_text(run_ + "/report.html"), page);
}

TEST_F(MadeAgain, IsTheErrorOfThePeakToo) {
  const app::ReadRun read = app::read_run(run_);
  RunRecord record = read.record();
  record.error_estimate.sources = {{"loading rate", "0.025 m/s", 1e6, 1e-5, 0.01, 0.02, 0.5}};
  record.notes = {"a note of the run"};
  write_run(run_, record);
  const std::string page = test::read_text(run_ + "/report.html");
  make(run_);
  EXPECT_EQ(test::read_text(run_ + "/report.html"), page);
  EXPECT_NE(page.find("0.025 m/s"), std::string::npos);
  EXPECT_NE(page.find("a note of the run"), std::string::npos);
}

TEST_F(RunReader, RefusesWhatIsNoRun) {
  EXPECT_THROW((void)app::read_run(run_ + "/result.h5"), app::Rejected);
  fs::remove(fs::path(run_) / "result.h5");
  EXPECT_THROW((void)app::read_run(run_), mpm::FileError);
}

}  // namespace run_location_test
