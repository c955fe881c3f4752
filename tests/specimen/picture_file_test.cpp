#include "specimen/picture_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/specimen/scratch.hpp"

namespace {

using specimen::Error;
using specimen::Fault;
using specimen_test::FileBytes;
using specimen_test::Scratch;
using ::testing::HasSubstr;

std::string reason_of(const std::string& path) {
  try {
    (void)specimen::open_picture(path, 1);
  } catch (const Error& error) {
    EXPECT_EQ(error.field, path);
    return error.what();
  }
  return "was opened";
}

TEST(PictureFile, SaysWhyAFileCannotBeOpened) {
  const Scratch scratch;
  EXPECT_THAT(reason_of(scratch.file("missing.png")), HasSubstr("cannot be read: No such file"));
  EXPECT_THAT(reason_of(scratch.file("")), HasSubstr("is no regular file"));
  ASSERT_EQ(::mkfifo(scratch.file("pipe").c_str(), 0600), 0);
  EXPECT_THAT(reason_of(scratch.file("pipe")), HasSubstr("is no regular file"));  // and does not wait for it
}

TEST(PictureFile, ReplacesAFileWholeAndLeavesNothingBesideIt) {
  const Scratch scratch;
  (void)scratch.write("a.bin", std::string("before"));
  specimen::write_whole_file(scratch.file("a.bin"), {1, 2, 3});
  EXPECT_EQ(scratch.read("a.bin"), (FileBytes{1, 2, 3}));
  EXPECT_EQ(scratch.files(), 1U);
}

TEST(PictureFile, LeavesNothingBehindWhenItCannotWrite) {
  const Scratch scratch;
  std::filesystem::create_directory(scratch.file("taken"));
  (void)scratch.write("taken/inside", std::string("x"));
  try {
    specimen::write_whole_file(scratch.file("taken"), {1});
    FAIL() << "a folder was replaced";
  } catch (const Error& error) {
    EXPECT_EQ(error.fault, Fault::write);
    EXPECT_THAT(error.what(), HasSubstr("taken: cannot be written: "));
  }
  EXPECT_EQ(scratch.files(), 1U);
  EXPECT_THROW(specimen::write_whole_file(scratch.file("no/such/folder"), {1}), Error);
}

TEST(PictureFile, SaysWhenTheDiskIsFull) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const auto source = [] { specimen::write_whole_file("/dev/full/a", {1}); };
  EXPECT_THROW(source(), Error);
}

}  // namespace
