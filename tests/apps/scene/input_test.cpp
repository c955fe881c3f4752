#include "apps/scene/input.hpp"

#include <gtest/gtest.h>

#include "specimen/file/specimen_file.hpp"
#include "tests/apps/small_specimen.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace app {
namespace input_test {

TEST(Input, IsToldByItsContent) {
  const test::TemporaryFolder folder;
  specimen::write_specimen(folder / "a", test::small_specimen());
  test::write_text(folder / "b", "P2 1 1 1 0");
  test::write_text(folder / "c.toml", "[generate]\nfraction = 0.2\n");
  EXPECT_EQ(resolve_input("INPUT", folder / "a", {}).settings.specimen.file, folder / "a");
  const Resolved picture = resolve_input("PICTURE", folder / "b", {});
  EXPECT_EQ(picture.settings.specimen.picture, folder / "b");
  EXPECT_EQ(picture.origins.at("specimen.picture").field, "PICTURE");
  const Assignment fraction = given_as_option("generate.fraction", Kind::quantity, "--fraction", "0.3");
  EXPECT_EQ(resolve_input("INPUT", folder / "c.toml", {}).settings.packing.fraction, 0.2);
  EXPECT_EQ(resolve_input("INPUT", folder / "c.toml", {fraction}).settings.packing.fraction, 0.3);
}

TEST(Input, RefusesFolders) {
  const test::TemporaryFolder folder;
  try {
    (void)resolve_input("INPUT", folder / "", {});
    FAIL();
  } catch (const Rejected& rejected) {
    EXPECT_EQ(rejected.code, Exit::usage);
    EXPECT_EQ(text(rejected.complaints.front()),
              "INPUT: " + (folder / "") + "; is a folder; must be a specimen, a scene or a picture");
  }
}

}  // namespace input_test
}  // namespace app
