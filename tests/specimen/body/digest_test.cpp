#include "specimen/body/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "specimen/body/error.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace digest_test {

using specimen::sha256_of_file;
using specimen::sha256_of_text;

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
}

}  // namespace digest_test
