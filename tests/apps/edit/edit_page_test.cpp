#include "apps/edit/edit_page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/edit/edit_session.hpp"

namespace edit_page_test {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(EditPage, HasAControlForEverySettingThatItChanges) {
  const std::string page = app::edit_page("photo.jpg", app::Settings());
  for (const std::string& key : app::edited_settings())
    EXPECT_THAT(page, HasSubstr("data-key=\"" + key + "\""));
}

TEST(EditPage, ShowsANameAsItIs) {
  const std::string page = app::edit_page("<script>alert(1)</script>.jpg", app::Settings());
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(page, HasSubstr("&lt;script&gt;alert(1)"));
}

TEST(EditPage, AsksItsOwnServerAlone) {
  EXPECT_THAT(app::edit_page("p", app::Settings()),
              HasSubstr("default-src 'none'; style-src 'unsafe-inline'; img-src data:; connect-src 'self'; "
                        "script-src 'sha256-"));
}

TEST(EditPage, WritesSettingsAsTheyAreRead) {
  app::Settings settings;
  EXPECT_EQ(app::text_of_setting("convert.drop_islands", settings), "auto");
  settings.convert.drop_islands = 1e-6;
  EXPECT_EQ(app::text_of_setting("convert.drop_islands", settings), "1 mm2");
  settings.convert.split_touching = true;
  EXPECT_EQ(app::text_of_setting("convert.split_touching", settings), "true");
}

}  // namespace edit_page_test
