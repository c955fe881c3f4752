/// Checks that the tests of all picture readers share.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "specimen/body/error.hpp"
#include "specimen/picture/picture.hpp"
#include "tests/specimen/scratch.hpp"

namespace specimen_test {

/// Reading the file fails with an Error that starts with its name and goes on as said.
inline void expect_refused(const std::string& path, const std::string& text) {
  try {
    (void)specimen::read_picture(path);
    FAIL() << path << " was read";
  } catch (const specimen::Error& error) {
    EXPECT_EQ(error.field, path);
    EXPECT_THAT(error.what(), ::testing::HasSubstr(text));
  }
}

/// Every beginning of a file is refused with an Error or, where only trailing bytes are missing, read.
/// @return how many were read.
inline int read_all_beginnings(const Scratch& scratch, const FileBytes& whole) {
  int read = 0;
  for (std::size_t n = 0; n < whole.size(); ++n) {
    const std::string path =
        scratch.write("cut", FileBytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(n)));
    try {
      (void)specimen::read_picture(path);
      ++read;
    } catch (const specimen::Error& error) {
      EXPECT_EQ(error.field, path);
    }
  }
  return read;
}

/// Each byte in turn is replaced by a few others; whatever comes, there is a picture or an Error, and nothing
/// that the sanitizers object to.
inline void survive_damage(const Scratch& scratch, const FileBytes& whole) {
  for (std::size_t i = 0; i < whole.size(); ++i)
    for (const int flip : {0x01, 0x80, 0xff}) {
      FileBytes damaged = whole;
      damaged[i] = static_cast<std::uint8_t>(damaged[i] ^ flip);
      const std::string path = scratch.write("damaged", damaged);
      try {
        const specimen::Picture picture = specimen::read_picture(path, 10'000);
        EXPECT_GT(picture.rows(), 0);
      } catch (const specimen::Error& error) {
        EXPECT_EQ(error.field, path);
      }
    }
}

}  // namespace specimen_test
