#include "apps/system/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "specimen/body/error.hpp"

namespace attempts_test {

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

}  // namespace attempts_test
