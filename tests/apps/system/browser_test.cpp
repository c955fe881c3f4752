#include "apps/system/browser.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace browser_test {

TEST(Browser, PageLeadsToTheAddress) {
  EXPECT_THAT(app::page_that_leads_to("http://127.0.0.1:1/abc/"),
              testing::HasSubstr("content=\"0; url=http://127.0.0.1:1/abc/\""));
}

}  // namespace browser_test
