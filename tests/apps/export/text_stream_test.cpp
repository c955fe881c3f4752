#include "apps/export/mesh_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "tests/specimen/temporary_folder.hpp"

namespace text_stream_test {

TEST(TextStream, HandsOnLargePiecesInOrder) {
  std::string received;
  std::size_t largest = 0;
  int pieces = 0;
  const specimen::ByteSink sink = [&](std::span<const std::byte> bytes) {
    received.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    largest = std::max(largest, bytes.size());
    ++pieces;
  };
  exchange::TextStream stream(sink);
  std::string expected;
  for (std::int64_t i = 0; i < 400'000; ++i) {
    stream << i << ", ";
    expected += std::to_string(i) + ", ";
  }
  EXPECT_LT(received.size(), expected.size()) << "the last piece is kept until the end";
  stream.flush();
  EXPECT_TRUE(received == expected);
  EXPECT_GT(pieces, 2);
  EXPECT_LT(pieces, 10);
  EXPECT_LT(largest, std::size_t{1} << 21) << "memory is bounded";
}

TEST(TextStream, WritesAFile) {
  const test::TemporaryFolder folder;
  exchange::write_text(folder / "a", [](exchange::TextStream& file) { file << "x " << -12 << "\n"; });
  EXPECT_EQ(test::read_text(folder / "a"), "x -12\n");
}

TEST(LengthText, FitsWhereTwentyCharactersAreAllowed) {
  EXPECT_EQ(exchange::length_text(3 * 0.1e-3), "0.0003") << "no noise of the last digit";
  EXPECT_EQ(exchange::length_text(0), "0");
  for (const double length : {1.0 / 3, 1e-3 / 3, 1e-4 / 3, 1e-5 / 3, 1e5 / 3})
    EXPECT_LE(exchange::length_text(length).size(), 20U);
}

}  // namespace text_stream_test
