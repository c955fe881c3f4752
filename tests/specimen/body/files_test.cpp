#include "specimen/body/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "specimen/body/error.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace files_test {

using specimen::replace_file;
using specimen::sha256_of_file;
using specimen::sha256_of_text;
using ::testing::HasSubstr;

void replace_with_text(const std::string& path, const std::string& text) {
  replace_file(path, std::as_bytes(std::span(text)));
}

std::string message_of_failure(const std::string& path, const std::string& text = "new") {
  try {
    replace_with_text(path, text);
  } catch (const specimen::Error& error) {
    EXPECT_EQ(error.field, path);
    EXPECT_EQ(error.fault, specimen::Fault::write);
    return error.what();
  }
  return "nothing was thrown";
}

/// Lets no file grow beyond a size while it lives, as a full disk would.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &old_limit_);
    const rlimit limit{bytes, old_limit_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &old_limit_);
    std::signal(SIGXFSZ, old_handler_);
  }

 private:
  rlimit old_limit_{};
  void (*old_handler_)(int);
};

TEST(ReplaceFile, PutsAllBytesInPlaceAndLeavesNothingElse) {
  const test::TemporaryFolder folder;
  replace_with_text(folder / "a", "first, and longer");
  replace_with_text(folder / "a", std::string("sec\0nd", 6));
  EXPECT_EQ(test::read_text(folder / "a"), std::string("sec\0nd", 6));
  EXPECT_EQ(folder.size(), 1);
}

TEST(ReplaceFile, KeepsTheOldFileWhenTheDiskIsFull) {
  const test::TemporaryFolder folder;
  replace_with_text(folder / "a", "old");
  {
    const FullDisk disk(1000);
    EXPECT_EQ(message_of_failure(folder / "a", std::string(5000, 'x')),
              (folder / "a") + ": could not be written: File too large");
  }
  EXPECT_EQ(test::read_text(folder / "a"), "old");
  EXPECT_EQ(folder.size(), 1) << "the temporary file was left behind";
}

TEST(ReplaceFile, TakesTheBytesPieceByPiece) {
  const test::TemporaryFolder folder;
  replace_file(folder / "a", [](const specimen::ByteSink& sink) {
    for (const std::string piece : {"one ", "", "two"}) sink(std::as_bytes(std::span(piece)));
  });
  EXPECT_EQ(test::read_text(folder / "a"), "one two");
}

TEST(ReplaceFile, KeepsTheOldFileWhenThePiecesBreakOff) {
  const test::TemporaryFolder folder;
  replace_with_text(folder / "a", "old");
  const auto break_off = [](const specimen::ByteSink& sink) {
    const std::string piece = "new";
    sink(std::as_bytes(std::span(piece)));
    throw std::runtime_error("no more");
  };
  EXPECT_THROW(replace_file(folder / "a", break_off), std::runtime_error);
  EXPECT_EQ(test::read_text(folder / "a"), "old");
  EXPECT_EQ(folder.size(), 1) << "the temporary file was left behind";
}

TEST(ReplaceFile, SaysWhatIsWrongWithAPath) {
  const test::TemporaryFolder folder;
  EXPECT_THAT(message_of_failure(folder / "none/a"),
              HasSubstr("No such file or directory; create its folder first"));
  EXPECT_THAT(message_of_failure(folder / ""), HasSubstr("it is a folder; give the name of a file"));
  EXPECT_THAT(message_of_failure("/dev/null"), HasSubstr("it is a device or a pipe"));
}

// Source: FIPS 180-4 examples (NIST): the empty message, one block, two blocks, a million times "a".
TEST(Digest, GivesTheKnownAnswers) {
  EXPECT_EQ(sha256_of_text(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_of_text("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of_text("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256_of_text(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Digest, OfAFileIsThatOfItsBytes) {
  const test::TemporaryFolder folder;
  std::string bytes(200'000, '\0');  // more than one piece, with zeros and line ends in it
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * 31 % 256);
  test::write_text(folder / "bytes", bytes);
  EXPECT_EQ(sha256_of_file(folder / "bytes"), sha256_of_text(bytes));
  test::write_text(folder / "empty", "");
  EXPECT_EQ(sha256_of_file(folder / "empty"), sha256_of_text(""));
}

TEST(Digest, SaysWhichFileCannotBeRead) {
  const test::TemporaryFolder folder;
  try {
    std::ignore = sha256_of_file(folder / "none");
    FAIL() << "a missing file was read";
  } catch (const specimen::Error& error) {
    EXPECT_EQ(error.field, folder / "none");
    EXPECT_EQ(error.value, "No such file or directory");
    EXPECT_EQ(error.fault, specimen::Fault::write);
  }
  EXPECT_THROW(std::ignore = sha256_of_file(folder / ""), specimen::Error);
  EXPECT_THROW(std::ignore = sha256_of_file("/dev/zero"), specimen::Error) << "which never ends";
}

}  // namespace files_test
