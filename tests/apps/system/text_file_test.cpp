#include "apps/system/files.hpp"

#include <gtest/gtest.h>

#include "tests/apps/refusal.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace text_file_test {

std::string message(const std::string& path, std::size_t longest) {
  return test::refusal([&] { (void)app::read_text_file(path, longest); });
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
  EXPECT_EQ(message("/dev/zero", app::longest_text), "/dev/zero: is too long; at most 16 MiB are read");
}

TEST(TextFile, SaysWhyItCannotBeRead) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(message(folder / "none", 1),
            folder / "none" + ": No such file or directory; must be a file that can be read");
  EXPECT_EQ(message(folder / "", 1), folder / "" + ": is a folder; must be a file that can be read");
}

}  // namespace text_file_test
