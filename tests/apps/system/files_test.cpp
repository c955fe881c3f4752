#include "apps/system/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <optional>
#include <vector>

#include "apps/text/complaint.hpp"
#include "libmpm/scene/error.hpp"
#include "specimen/body/error.hpp"
#include "tests/apps/refusal.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace files_test {

namespace fs = std::filesystem;

std::string message(const std::string& path, std::size_t longest) {
  return test::refusal([&] { (void)app::read_text_file(path, longest); });
}

TEST(Ending, IsWhatFollowsTheLastDotInSmallLetters) {
  EXPECT_EQ(app::ending_of("a.b/photo.2.JPG"), ".jpg");
  EXPECT_EQ(app::ending_of("a.b/photo"), "");
}

TEST(TextFile, IsReadWhole) {
  const test::TemporaryFolder folder;
  const std::string text = std::string(100'000, 'a') + '\0' + "\r\n";
  test::write_text(folder / "a.txt", text);
  EXPECT_EQ(app::read_text_file(folder / "a.txt"), text);
  test::write_text(folder / "empty.txt", "");
  EXPECT_EQ(app::read_text_file(folder / "empty.txt"), "");
}

TEST(TextFile, IsReadAsFarAsIsAllowed) {
  const test::TemporaryFolder folder;
  const std::string path = folder / "a.txt";
  constexpr std::size_t longest = std::size_t{1} << 20U;
  test::write_text(path, std::string(longest, 'a'));
  EXPECT_EQ(app::read_text_file(path, longest).size(), longest);
  test::write_text(path, std::string(longest + 1, 'a'));
  EXPECT_EQ(message(path, longest), path + ": is too long; at most 1 MiB are read");
}

TEST(TextFile, ThatNeverEndsIsRefused) {
  const test::TemporaryFolder folder;
  const std::string pipe = folder / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& path : {std::string("/dev/zero"), pipe})
    EXPECT_EQ(message(path, app::longest_text),
              path +
                  ": is not a regular file; must be a file that can be read; "
                  "save what comes from the pipe or device in a file first");
}

TEST(TextFile, SaysWhyItCannotBeRead) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(message(folder / "none", 1),
            folder / "none" + ": No such file or directory; must be a file that can be read");
  EXPECT_EQ(message(folder / "", 1), folder / "" + ": is a folder; must be a file that can be read");
}

TEST(Attempts, TriesEveryWriteWhateverBecameOfThoseBefore) {
  Attempts attempt;
  int tried = 0;
  attempt([&] {
    ++tried;
    throw mpm::FileError("result.h5", "cannot be written: No space left on device", "", "make space");
  });
  attempt([&] { ++tried; });
  attempt([&] {
    ++tried;
    throw specimen::Error("specimen.png", "could not be written", "allowed", "cure", specimen::Fault::write);
  });
  EXPECT_EQ(tried, 3);
  try {
    attempt.conclude();
    FAIL() << "two files are missing";
  } catch (const NotWritten& missing) {
    ASSERT_EQ(missing.files.size(), 2U);
    EXPECT_STREQ(missing.what(), "result.h5: cannot be written: No space left on device; make space");
    EXPECT_STREQ(missing.files[1].what(), "specimen.png: could not be written; allowed; cure");
  }
}

TEST(Attempts, SaysNothingWhenAllIsWritten) {
  Attempts attempt;
  attempt([] {});
  EXPECT_NO_THROW(attempt.conclude());
}

TEST(Attempts, LetsWhatIsNoFaultOfTheDiskPass) {
  Attempts attempt;
  EXPECT_THROW(attempt([] { throw specimen::Error("mask", "empty", ""); }), specimen::Error);
  EXPECT_THROW(attempt([] { throw std::logic_error("a bug"); }), std::logic_error);
  EXPECT_NO_THROW(attempt.conclude());
}

/// A number that no process has.
pid_t process_that_is_gone() {
  const pid_t process = ::fork();
  if (process == 0) ::_exit(0);
  ::waitpid(process, nullptr, 0);
  return process;
}

TEST(Remainders, OfProgramsThatAreGoneAreRemoved) {
  const test::TemporaryFolder folder;
  const std::string gone = std::to_string(process_that_is_gone()), here = std::to_string(::getpid()),
                    other = std::to_string(::getppid());
  const std::vector<std::string> doomed{"scene.toml." + gone + "-0.tmp", "specimen.h5.tmp-" + gone + "-12",
                                        "result.h5." + here + "-3.tmp"};
  const std::vector<std::string> kept{
      "result.h5." + other + "-3.tmp", "notes.tmp",          "x." + gone + ".tmp", "x.tmp-" + gone,
      "." + gone + "-0.tmp",           "x.99999999999-0.tmp"};
  for (const auto* names : {&doomed, &kept})
    for (const std::string& name : *names) test::write_text(folder / name, "");
  app::remove_remainders(folder / "");
  for (const std::string& name : doomed) EXPECT_FALSE(fs::exists(folder / name)) << name;
  for (const std::string& name : kept) EXPECT_TRUE(fs::exists(folder / name)) << name;
  app::remove_remainders(folder / "none");
}

TEST(Remainders, ThatAreOldAreRemovedWhoeverWroteThem) {
  const test::TemporaryFolder folder;
  for (const char* name : {"old.h5.1-0.tmp", "new.h5.1-1.tmp", "old.h5"}) test::write_text(folder / name, "");
  for (const char* name : {"old.h5.1-0.tmp", "old.h5"})
    fs::last_write_time(folder / name, fs::file_time_type::clock::now() - std::chrono::hours(2));
  app::remove_old_remainders(folder / "");
  EXPECT_FALSE(fs::exists(folder / "old.h5.1-0.tmp"));
  EXPECT_TRUE(fs::exists(folder / "new.h5.1-1.tmp"));
  EXPECT_TRUE(fs::exists(folder / "old.h5"));
}

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

}  // namespace files_test
