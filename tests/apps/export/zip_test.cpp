#include "apps/export/imagej.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "specimen/body/error.hpp"

namespace zip_test {

using testing::HasSubstr;
using testing::StartsWith;

const std::vector<exchange::NamedBytes> files{{"b.roi", std::string(500, 'x')}, {"a.roi", "second"}};

TEST(Zip, HoldsTheFilesByName) {
  const std::string archive = exchange::zipped("a.zip", files);
  EXPECT_THAT(archive, StartsWith("PK\x03\x04"));
  EXPECT_THAT(archive, HasSubstr("b.roi"));
  EXPECT_THAT(archive.substr(archive.find("b.roi")), HasSubstr("a.roi")) << "in their order";
  EXPECT_LT(archive.size(), 500U) << "compressed";
}

TEST(Zip, SaysNothingOfTheTime) {
  const std::string archive = exchange::zipped("a.zip", files);
  EXPECT_EQ(archive.substr(10, 4), std::string("\0\0\x21\0", 4)) << "midnight, 1 January 1980";
}

TEST(Zip, NamesTheFileThatItCannotMake) {
  try {
    (void)exchange::zipped("a.zip", {{"same", "1"}, {"same", "2"}});
    FAIL();
  } catch (const specimen::Error& error) {
    EXPECT_EQ(error.fault, specimen::Fault::write);
    EXPECT_STREQ(error.what(), "a.zip: cannot be written as ZIP: File already exists");
  }
}

}  // namespace zip_test
