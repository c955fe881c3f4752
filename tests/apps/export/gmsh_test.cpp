#include "apps/export/mesh_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/export/small_mask.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace gmsh_test {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string written(const specimen::LabelledMask& mask) {
  const test::TemporaryFolder folder;
  exchange::write_gmsh(folder / "a.msh", exchange::PixelMesh(mask));
  return test::read_text(folder / "a.msh");
}

TEST(Gmsh, WritesGroupsEntitiesNodesAndElements) {
  const std::string text = written(test::mask_of({"12", "02"}, 0.5e-3));
  EXPECT_THAT(text, StartsWith("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Comments\n"));
  EXPECT_THAT(text, HasSubstr("Lengths are in metres."));
  EXPECT_EQ(text.substr(text.find("$PhysicalNames\n")),
            "$PhysicalNames\n6\n1 1 \"BOTTOM\"\n1 2 \"RIGHT\"\n1 3 \"TOP\"\n1 4 \"LEFT\"\n"
            "2 1 \"aggregate\"\n2 2 \"mortar\"\n$EndPhysicalNames\n"
            "$Entities\n0 4 2 0\n"
            "1 0 0 0 0.001 0.001 0 1 1 0\n2 0 0 0 0.001 0.001 0 1 2 0\n"
            "3 0 0 0 0.001 0.001 0 1 3 0\n4 0 0 0 0.001 0.001 0 1 4 0\n"
            "1 0 0 0 0.001 0.001 0 1 1 0\n2 0 0 0 0.001 0.001 0 1 2 0\n$EndEntities\n"
            "$Nodes\n1 8 1 9\n2 1 0 8\n1\n2\n3\n4\n5\n6\n8\n9\n"
            "0 0.001 0\n0.0005 0.001 0\n0.001 0.001 0\n0 0.0005 0\n0.0005 0.0005 0\n0.001 0.0005 0\n"
            "0.0005 0 0\n0.001 0 0\n$EndNodes\n"
            "$Elements\n6 9 1 10\n"
            "1 1 1 1\n5 8 9\n1 2 1 2\n6 9 6\n7 6 3\n1 3 1 2\n8 3 2\n9 2 1\n1 4 1 1\n10 1 4\n"
            "2 1 3 1\n1 4 5 2 1\n2 2 3 2\n2 5 6 3 2\n4 8 9 6 5\n$EndElements\n");
}

TEST(Gmsh, LeavesOutTheCurveOfAnEdgeThatIsVoid) {
  const std::string text = written(test::mask_of({"20"}));
  EXPECT_THAT(text, HasSubstr("$PhysicalNames\n4\n"));
  EXPECT_THAT(text, HasSubstr("$Entities\n0 3 1 0\n"));
  EXPECT_THAT(text, Not(HasSubstr("RIGHT")));
}

}  // namespace gmsh_test
