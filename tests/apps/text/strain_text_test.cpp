#include "apps/text/figures.hpp"

#include <gtest/gtest.h>

namespace strain_text_test {

TEST(StrainText, IsInPercentFromOnePercentOn) {
  EXPECT_EQ(app::strain_text(940.27e-6), "940.3e-6");
  EXPECT_EQ(app::strain_text(0), "0e-6");
  EXPECT_EQ(app::strain_text(0.01), "1 %");
  EXPECT_EQ(app::strain_text(0.023128), "2.313 %");
}

}  // namespace strain_text_test
