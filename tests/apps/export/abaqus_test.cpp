#include "apps/export/mesh_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/export/small_mask.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace abaqus_test {

using exchange::PlaneElement;
using testing::HasSubstr;
using testing::Not;

std::string written(const specimen::LabelledMask& mask, PlaneElement plane = PlaneElement::stress) {
  const test::TemporaryFolder folder;
  exchange::write_abaqus(folder / "a.inp", exchange::PixelMesh(mask), plane);
  return test::read_text(folder / "a.inp");
}

TEST(Abaqus, WritesNodesElementSetsAndNodeSets) {
  const std::string text = written(test::mask_of({"12", "02"}, 0.5e-3));
  EXPECT_THAT(text, HasSubstr("** Lengths are in metres."));
  EXPECT_THAT(text, HasSubstr("**   *SOLID SECTION, ELSET=MORTAR, MATERIAL=M_MORTAR\n"));
  EXPECT_EQ(text.substr(text.find("*NODE\n")),
            "*NODE\n"
            "1, 0, 0.001\n2, 0.0005, 0.001\n3, 0.001, 0.001\n"
            "4, 0, 0.0005\n5, 0.0005, 0.0005\n6, 0.001, 0.0005\n"
            "8, 0.0005, 0\n9, 0.001, 0\n"
            "*ELEMENT, TYPE=CPS4, ELSET=AGGREGATE\n1, 4, 5, 2, 1\n"
            "*ELEMENT, TYPE=CPS4, ELSET=MORTAR\n2, 5, 6, 3, 2\n4, 8, 9, 6, 5\n"
            "*NSET, NSET=BOTTOM\n8, 9\n"
            "*NSET, NSET=RIGHT\n9, 6, 3\n"
            "*NSET, NSET=TOP\n3, 2, 1\n"
            "*NSET, NSET=LEFT\n1, 4\n");
}

TEST(Abaqus, HasElementsOfPlaneStrainToo) {
  const std::string text = written(test::mask_of({"2"}), PlaneElement::strain);
  EXPECT_THAT(text, HasSubstr("TYPE=CPE4"));
  EXPECT_THAT(text, Not(HasSubstr("CPS4")));
}

TEST(Abaqus, PutsSixteenNumbersOnALineAtMost) {
  const std::string text = written(test::mask_of({std::string(16, '2')}));
  EXPECT_THAT(
      text,
      HasSubstr("*NSET, NSET=BOTTOM\n18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33\n34\n"
                "*NSET, NSET=RIGHT\n"));
}

TEST(Abaqus, LeavesOutTheSetOfAnEdgeThatIsVoid) {
  const std::string text = written(test::mask_of({"20"}));
  EXPECT_THAT(text, HasSubstr("NSET=LEFT"));
  EXPECT_THAT(text, Not(HasSubstr("NSET=RIGHT")));
}

TEST(Abaqus, InventsNoMaterial) { EXPECT_THAT(written(test::mask_of({"2"})), Not(HasSubstr("\n*MATERIAL"))); }

}  // namespace abaqus_test
