#include "specimen/picture/picture_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/specimen/scratch.hpp"

namespace picture_file_test {

using specimen::Error;
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
  EXPECT_THAT(reason_of(scratch.file("")), HasSubstr("is not a regular file"));
  ASSERT_EQ(::mkfifo(scratch.file("pipe").c_str(), 0600), 0);
  EXPECT_THAT(reason_of(scratch.file("pipe")),
              HasSubstr("is not a regular file"));  // and does not wait for it
}

}  // namespace picture_file_test
