#include "libmpm/solver/checkpoint.hpp"

#include <gtest/gtest.h>

#include <cstdio>

namespace sha256_test {

std::string hexadecimal(const std::string& digest) {
  std::string text;
  for (const char byte : digest) {
    char two[3];
    std::snprintf(two, sizeof two, "%02x", static_cast<unsigned>(static_cast<unsigned char>(byte)));
    text += two;
  }
  return text;
}

// FIPS 180-4 and its examples.
TEST(Sha256, GivesTheKnownDigests) {
  EXPECT_EQ(hexadecimal(mpm::Sha256().digest()),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(hexadecimal(mpm::Sha256().add("abc").digest()),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Sha256, IsThatOfThePiecesTogether) {
  EXPECT_EQ(mpm::Sha256().add("a").add("").add("bc").digest(), mpm::Sha256().add("abc").digest());
}

}  // namespace sha256_test
