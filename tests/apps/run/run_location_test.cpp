#include "apps/run/run_location.hpp"

#include <gtest/gtest.h>

#include "apps/text/complaint.hpp"
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

}  // namespace run_location_test
