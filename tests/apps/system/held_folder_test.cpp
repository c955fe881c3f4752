#include "apps/system/files.hpp"

#include <gtest/gtest.h>

#include <optional>

#include "apps/text/complaint.hpp"
#include "libmpm/scene/error.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace held_folder_test {

namespace fs = std::filesystem;

class HeldFolder : public testing::Test {
 protected:
  /// Code and message of what was refused.
  std::optional<std::pair<app::Exit, std::string>> refused() const {
    try {
      const app::HeldFolder second(folder());
      return std::nullopt;
    } catch (const app::Rejected& rejected) {
      return std::pair(rejected.code, std::string(rejected.what()));
    }
  }
  fs::path folder() const { return folder_ / ""; }
  fs::path lock() const { return folder_ / "in_progress.lock"; }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(HeldFolder, IsRefusedToASecond) {
  const app::HeldFolder first(folder());
  const auto why = refused();
  ASSERT_TRUE(why);
  EXPECT_EQ(why->first, app::Exit::interrupted);
  EXPECT_EQ(why->second, folder().parent_path().string() +
                             ": another program is writing a run there; wait until it has ended, or choose "
                             "another folder");
  EXPECT_TRUE(refused()) << "the refused one has let the folder go";
}

TEST_F(HeldFolder, IsFreeAfterwardsAndNothingStays) {
  { const app::HeldFolder first(folder()); }
  EXPECT_TRUE(fs::is_empty(folder()));
  EXPECT_FALSE(refused());
}

TEST_F(HeldFolder, AFileThatACrashLeftHoldsNothing) {
  test::write_text(lock(), "");
  EXPECT_FALSE(refused());
  EXPECT_FALSE(fs::exists(lock()));
}

TEST_F(HeldFolder, LeavesTheLockOfAnotherInItsPlace) {
  const fs::path place = folder() / "run", elsewhere = folder() / "moved";
  fs::create_directory(place);
  std::optional<app::HeldFolder> first(std::in_place, place);
  fs::rename(place, elsewhere);
  fs::create_directory(place);
  const app::HeldFolder second(place);
  first.reset();
  EXPECT_TRUE(fs::exists(place / "in_progress.lock"));
}

TEST_F(HeldFolder, AFolderThatIsNotThereIsAMatterOfTheDisk) {
  EXPECT_THROW(app::HeldFolder(folder() / "missing"), mpm::FileError);
}

}  // namespace held_folder_test
