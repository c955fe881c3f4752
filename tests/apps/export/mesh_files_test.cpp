#include "apps/export/mesh_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <sstream>

#include "tests/apps/export/small_mask.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace mesh_files_test {

using exchange::PlaneElement;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string written_abaqus(const specimen::LabelledMask& mask, PlaneElement plane = PlaneElement::stress) {
  const test::TemporaryFolder folder;
  exchange::write_abaqus(folder / "a.inp", exchange::PixelMesh(mask), plane);
  return test::read_text(folder / "a.inp");
}

TEST(Abaqus, WritesNodesElementSetsAndNodeSets) {
  const std::string text = written_abaqus(test::mask_of({"12", "02"}, 0.5e-3));
  EXPECT_THAT(text, HasSubstr("** Lengths are in metres."));
  EXPECT_THAT(text, HasSubstr("**   *SOLID SECTION, ELSET=MORTAR, MATERIAL=M_MORTAR\n"));
  EXPECT_EQ(text.substr(text.find("*NODE\n")),
            "*NODE\n"
            "1, 0, 0.001\n2, 0.0005, 0.001\n3, 0.001, 0.001\n"
            "4, 0, 0.0005\n5, 0.0005, 0.0005\n6, 0.001, 0.0005\n"
            "7, 0.0005, 0\n8, 0.001, 0\n"
            "*ELEMENT, TYPE=CPS4, ELSET=AGGREGATE\n1, 4, 5, 2, 1\n"
            "*ELEMENT, TYPE=CPS4, ELSET=MORTAR\n2, 5, 6, 3, 2\n3, 7, 8, 6, 5\n"
            "*NSET, NSET=BOTTOM\n7, 8\n"
            "*NSET, NSET=RIGHT\n8, 6, 3\n"
            "*NSET, NSET=TOP\n3, 2, 1\n"
            "*NSET, NSET=LEFT\n1, 4\n");
}

TEST(Abaqus, HasElementsOfPlaneStrainToo) {
  const std::string text = written_abaqus(test::mask_of({"2"}), PlaneElement::strain);
  EXPECT_THAT(text, HasSubstr("TYPE=CPE4"));
  EXPECT_THAT(text, Not(HasSubstr("CPS4")));
}

TEST(Abaqus, PutsSixteenNumbersOnALineAtMost) {
  const std::string text = written_abaqus(test::mask_of({std::string(16, '2')}));
  EXPECT_THAT(
      text,
      HasSubstr("*NSET, NSET=BOTTOM\n18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33\n34\n"
                "*NSET, NSET=RIGHT\n"));
}

TEST(Abaqus, LeavesOutTheSetOfAnEdgeThatIsVoid) {
  const std::string text = written_abaqus(test::mask_of({"20"}));
  EXPECT_THAT(text, HasSubstr("NSET=LEFT"));
  EXPECT_THAT(text, Not(HasSubstr("NSET=RIGHT")));
}

TEST(Abaqus, InventsNoMaterial) {
  EXPECT_THAT(written_abaqus(test::mask_of({"2"})), Not(HasSubstr("\n*MATERIAL")));
}

std::string written_test(const std::vector<std::string>& rows, const exchange::ElasticTest& elastic) {
  const test::TemporaryFolder folder;
  const specimen::LabelledMask mask = test::mask_of(rows, 0.5e-3);
  exchange::write_abaqus(folder / "a.inp", exchange::PixelMesh(mask), PlaneElement::strain, elastic);
  return test::read_text(folder / "a.inp");
}

exchange::ElasticTest elastic_test() {
  exchange::ElasticTest elastic;
  elastic.materials = {std::nullopt, {{40e9, 0.2, 2400}}, {{20e9, 0.25, 2300}}};
  return elastic;
}

TEST(Abaqus, HasMaterialsAndAStepOfATest) {
  const std::string text = written_test({"12", "22"}, elastic_test());
  EXPECT_THAT(text, Not(HasSubstr("Before an analysis")));
  EXPECT_EQ(
      text.substr(text.find("*MATERIAL")),
      "*MATERIAL, NAME=M_AGGREGATE\n*ELASTIC\n4e+10, 0.2\n*DENSITY\n2400\n"
      "*SOLID SECTION, ELSET=AGGREGATE, MATERIAL=M_AGGREGATE\n1.\n"
      "*MATERIAL, NAME=M_MORTAR\n*ELASTIC\n2e+10, 0.25\n*DENSITY\n2300\n"
      "*SOLID SECTION, ELSET=MORTAR, MATERIAL=M_MORTAR\n1.\n"
      "** The top edge is moved by a strain of 0.0001 over the height; the sum of the reactions, over the "
      "width, is the stress.\n"
      "*BOUNDARY\nBOTTOM, 2, 2\n7, 1, 1\n*STEP\n*STATIC\n*BOUNDARY\nTOP, 2, 2, 1e-07\n"
      "*NODE PRINT, NSET=TOP, TOTALS=ONLY\nRF\n*NODE FILE\nU\n*EL FILE\nS, E\n*END STEP\n");
}

TEST(Abaqus, HoldsTheEdgesBetweenRoughPlatens) {
  exchange::ElasticTest elastic = elastic_test();
  elastic.rough = true;
  elastic.strain = -1e-4;
  const std::string text = written_test({"2"}, elastic);
  EXPECT_THAT(text, HasSubstr("BOTTOM, 2, 2\nBOTTOM, 1, 1\nTOP, 1, 1\n*STEP"));
  EXPECT_THAT(text, HasSubstr("TOP, 2, 2, -5e-08\n"));
}

TEST(Abaqus, SaysWhatATestLacks) {
  exchange::ElasticTest elastic = elastic_test();
  elastic.materials.pop_back();
  const std::string text = written_test({"00", "12"}, elastic);
  EXPECT_THAT(text, HasSubstr("**   *MATERIAL, NAME=M_MORTAR\n"));
  EXPECT_THAT(text, Not(HasSubstr("\n*MATERIAL, NAME=M_MORTAR")));
  EXPECT_THAT(text, HasSubstr("\n*MATERIAL, NAME=M_AGGREGATE"));
  EXPECT_THAT(text, Not(HasSubstr("*STEP"))) << "the top edge is void";
}

/// CalculiX 2.20 reads the first 20 characters of a number and drops what follows, an exponent too.
TEST(Abaqus, HasNoNumberOfMoreThanTwentyCharacters) {
  exchange::ElasticTest elastic;
  elastic.materials = {std::nullopt, exchange::ElasticTest::Material{1e11 / 3, 1.0 / 3, 2e4 / 7},
                       exchange::ElasticTest::Material{1e-7 / 3, -1.0 / 3, 1e-7 / 7}};
  elastic.strain = -1e-4 / 3;
  const test::TemporaryFolder folder;
  const auto mask = test::mask_of({"1222222", "2222222", "2222222"}, 1e-6 / 7);
  exchange::write_abaqus(folder / "a.inp", exchange::PixelMesh(mask), PlaneElement::stress, elastic);
  const std::string text = test::read_text(folder / "a.inp");
  std::istringstream lines(text.substr(text.find("*NODE\n")));  // behind the heading, which is prose
  int numbers = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '*') continue;
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) {
      field.erase(0, field.find_first_not_of(' '));
      EXPECT_LE(field.size(), 20U) << line;
      ++numbers;
    }
  }
  EXPECT_GT(numbers, 3 * 32 + 5 * 21) << "nodes and elements are among them";
}

std::string written_gmsh(const specimen::LabelledMask& mask) {
  const test::TemporaryFolder folder;
  exchange::write_gmsh(folder / "a.msh", exchange::PixelMesh(mask));
  return test::read_text(folder / "a.msh");
}

TEST(Gmsh, WritesGroupsEntitiesNodesAndElements) {
  const std::string text = written_gmsh(test::mask_of({"12", "02"}, 0.5e-3));
  EXPECT_THAT(text, StartsWith("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Comments\n"));
  EXPECT_THAT(text, HasSubstr("Lengths are in metres."));
  EXPECT_EQ(text.substr(text.find("$PhysicalNames\n")),
            "$PhysicalNames\n6\n1 1 \"BOTTOM\"\n1 2 \"RIGHT\"\n1 3 \"TOP\"\n1 4 \"LEFT\"\n"
            "2 1 \"aggregate\"\n2 2 \"mortar\"\n$EndPhysicalNames\n"
            "$Entities\n0 4 2 0\n"
            "1 0 0 0 0.001 0.001 0 1 1 0\n2 0 0 0 0.001 0.001 0 1 2 0\n"
            "3 0 0 0 0.001 0.001 0 1 3 0\n4 0 0 0 0.001 0.001 0 1 4 0\n"
            "1 0 0 0 0.001 0.001 0 1 1 0\n2 0 0 0 0.001 0.001 0 1 2 0\n$EndEntities\n"
            "$Nodes\n1 8 1 8\n2 1 0 8\n1\n2\n3\n4\n5\n6\n7\n8\n"
            "0 0.001 0\n0.0005 0.001 0\n0.001 0.001 0\n0 0.0005 0\n0.0005 0.0005 0\n0.001 0.0005 0\n"
            "0.0005 0 0\n0.001 0 0\n$EndNodes\n"
            "$Elements\n6 9 1 9\n"
            "1 1 1 1\n4 7 8\n1 2 1 2\n5 8 6\n6 6 3\n1 3 1 2\n7 3 2\n8 2 1\n1 4 1 1\n9 1 4\n"
            "2 1 3 1\n1 4 5 2 1\n2 2 3 2\n2 5 6 3 2\n3 7 8 6 5\n$EndElements\n");
}

TEST(Gmsh, LeavesOutTheCurveOfAnEdgeThatIsVoid) {
  const std::string text = written_gmsh(test::mask_of({"20"}));
  EXPECT_THAT(text, HasSubstr("$PhysicalNames\n4\n"));
  EXPECT_THAT(text, HasSubstr("$Entities\n0 3 1 0\n"));
  EXPECT_THAT(text, Not(HasSubstr("RIGHT")));
}

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

}  // namespace mesh_files_test
