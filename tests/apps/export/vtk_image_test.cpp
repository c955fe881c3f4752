#include "apps/export/mesh_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/export/small_mask.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace vtk_image_test {

using testing::EndsWith;
using testing::HasSubstr;

TEST(VtkImage, CountsRowsFromBelowAndVoidToo) {
  const test::TemporaryFolder folder;
  exchange::write_vtk_image(folder / "a.vti", test::mask_of({"123", "022"}, 0.5e-3));
  const std::string text = test::read_text(folder / "a.vti");
  EXPECT_THAT(
      text,
      HasSubstr(R"(<ImageData WholeExtent="0 3 0 2 0 0" Origin="0 0 0" Spacing="0.0005 0.0005 0.0005">)"));
  const std::string size("\x06\0\0\0\0\0\0\0", 8);
  const std::string cells("\x00\x02\x02\x01\x02\x03", 6);
  EXPECT_THAT(text, EndsWith("\n_" + size + cells + "\n</AppendedData>\n</VTKFile>\n"));
}

TEST(VtkImage, SpellsTheNamesOfThePhases) {
  const test::TemporaryFolder folder;
  auto mask = test::mask_of({"1"});
  mask.phases = {"void", "A\"ä"};
  exchange::write_vtk_image(folder / "a.vti", mask);
  EXPECT_THAT(
      test::read_text(folder / "a.vti"),
      HasSubstr("NumberOfTuples=\"2\" format=\"ascii\">\n118 111 105 100 0\n65 34 195 164 0\n</Array>"));
}

}  // namespace vtk_image_test
