#include "apps/export/pixel_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "specimen/body/error.hpp"
#include "tests/apps/export/small_mask.hpp"

namespace pixel_mesh_test {

using exchange::Edge;
using exchange::PixelMesh;
using testing::ElementsAre;
using testing::IsEmpty;
using Side = std::array<std::int64_t, 2>;

// The nodes of three columns and two rows:
//   1  2  3  4
//   5  6  7  8
//   9 10 11 12

TEST(PixelMesh, GoesRoundAPixelCounterClockwiseFromTheBottomLeft) {
  const auto mask = test::mask_of({"222", "222"});
  const PixelMesh mesh(mask);
  EXPECT_THAT(mesh.corners(0, 0), ElementsAre(5, 6, 2, 1));
  EXPECT_THAT(mesh.corners(1, 2), ElementsAre(11, 12, 8, 7));
  EXPECT_EQ(mesh.element(1, 2), 6);
  EXPECT_EQ(mesh.nodes(), 12);
  EXPECT_EQ(mesh.elements(), 6);
}

TEST(PixelMesh, TopLinesLieHighest) {
  const auto mask = test::mask_of({"222", "222"});
  const PixelMesh mesh(mask);
  EXPECT_THAT(mesh.x_texts(), ElementsAre("0", "0.001", "0.002", "0.003"));
  EXPECT_THAT(mesh.y_texts(), ElementsAre("0.002", "0.001", "0"));
}

TEST(PixelMesh, SidesGoRoundTheSpecimenCounterClockwise) {
  const auto mask = test::mask_of({"222", "222"});
  const PixelMesh mesh(mask);
  EXPECT_THAT(mesh.sides(Edge::bottom), ElementsAre(Side{9, 10}, Side{10, 11}, Side{11, 12}));
  EXPECT_THAT(mesh.sides(Edge::right), ElementsAre(Side{12, 8}, Side{8, 4}));
  EXPECT_THAT(mesh.sides(Edge::top), ElementsAre(Side{4, 3}, Side{3, 2}, Side{2, 1}));
  EXPECT_THAT(mesh.sides(Edge::left), ElementsAre(Side{1, 5}, Side{5, 9}));
  EXPECT_THAT(mesh.nodes_on(Edge::bottom), ElementsAre(9, 10, 11, 12));
}

TEST(PixelMesh, VoidHasNoElementsNoNodesAndNoEdge) {
  const auto mask = test::mask_of({"200", "020"});
  const PixelMesh mesh(mask);
  std::vector<std::int64_t> nodes;
  mesh.for_each_node([&](exchange::MeshNode node) { nodes.push_back(mesh.number(node)); });
  EXPECT_THAT(nodes, ElementsAre(1, 2, 3, 4, 5, 6, 7));
  EXPECT_EQ(mesh.nodes(), 7);
  EXPECT_EQ(mesh.elements(), 2);
  EXPECT_THAT(mesh.corners(1, 1), ElementsAre(6, 7, 5, 4));
  EXPECT_THAT(mesh.sides(Edge::right), IsEmpty());
  EXPECT_THAT(mesh.nodes_on(Edge::top), ElementsAre(2, 1));
  EXPECT_THAT(mesh.nodes_on(Edge::bottom), ElementsAre(6, 7));
}

/// CalculiX 2.20 takes 80 bytes for every number of a node and 380 for every number of an element, up to the
/// largest, be they there or not.
TEST(PixelMesh, LeavesNoNumberOutAmidVoid) {
  std::vector<std::string> rows(5, std::string(150, '0'));  // more than two words of 64 bits a row
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t col = 0; col < 150; ++col)
      if ((row * 7 + col * col) % 5 < 2) rows[row][col] = '2';
  const auto mask = test::mask_of(rows);
  const PixelMesh mesh(mask);
  std::int64_t nodes = 0;
  mesh.for_each_node([&](exchange::MeshNode node) { EXPECT_EQ(mesh.number(node), ++nodes); });
  EXPECT_EQ(mesh.nodes(), nodes);
  std::int64_t elements = 0;
  mesh.for_each_element(mesh.phases()[0], [&](int row, int col) {
    EXPECT_EQ(mesh.element(row, col), ++elements);
    EXPECT_EQ(mesh.corners(row, col)[3], mesh.number({row, col})) << "the top left corner";
  });
  EXPECT_EQ(mesh.elements(), elements);
  EXPECT_GT(elements, 200);
  EXPECT_LT(elements, 5 * 150 / 2);
}

TEST(PixelMesh, AnEdgeWithAGapNamesEachNodeOnce) {
  const auto mask = test::mask_of({"20202", "22222"});
  EXPECT_THAT(PixelMesh(mask).nodes_on(Edge::top), ElementsAre(6, 5, 4, 3, 2, 1));
}

TEST(PixelMesh, KnowsThePhasesThatOccur) {
  auto mask = test::mask_of({"204", "224"});
  mask.phases.emplace_back("steel");
  const PixelMesh mesh(mask);
  ASSERT_EQ(mesh.phases().size(), 2U);
  EXPECT_EQ(mesh.phases()[1].label, 4);
  EXPECT_EQ(mesh.phases()[1].name, "steel");
  EXPECT_EQ(mesh.phases()[1].elements, 2);
  std::vector<std::int64_t> elements;
  mesh.for_each_element(mesh.phases()[1],
                        [&](int row, int col) { elements.push_back(mesh.element(row, col)); });
  EXPECT_THAT(elements, ElementsAre(2, 5));
}

TEST(PixelMesh, OfNothingIsRefused) {
  const auto mask = test::mask_of({"00"});
  try {
    const PixelMesh mesh(mask);
    FAIL();
  } catch (const specimen::Error& error) {
    EXPECT_STREQ(error.what(), "specimen: is void throughout; a mesh needs a pixel that is not");
  }
}

}  // namespace pixel_mesh_test
