#include "apps/report/report_data.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace deflate_test {

using output::deflated_base64;

TEST(Deflate, IsTheFormatOfZlib) {
  // Of Python: base64.b64encode(zlib.compress(b"aaaaaaaaaa"))
  EXPECT_EQ(deflated_base64(std::string_view("aaaaaaaaaa")), "eJxLTIQBABThA8s=");
  EXPECT_EQ(deflated_base64(std::string_view()), "eJwDAAAAAAE=");
}

TEST(Deflate, TakesTheBytesOfArrays) {
  const std::vector<std::uint16_t> values{0x6161, 0x6161, 0x6161, 0x6161, 0x6161};
  EXPECT_EQ(deflated_base64(std::span<const std::uint16_t>(values)),
            deflated_base64(std::string_view("aaaaaaaaaa")));
}

}  // namespace deflate_test
