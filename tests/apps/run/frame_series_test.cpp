#include "apps/run/frame_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace frame_series_test {

using testing::HasSubstr;

TEST(FrameName, SortsByNumberAndIsKnownAgain) {
  EXPECT_EQ(output::frame_name(0), "p_000000.hdf");
  EXPECT_EQ(output::frame_name(12), "p_000012.hdf");
  EXPECT_EQ(output::frame_name(1234567), "p_1234567.hdf");
  for (const int number : {0, 12, 1234567}) EXPECT_TRUE(output::is_frame_name(output::frame_name(number)));
  for (const char* other : {"", "p_.hdf", "p_00012.hdf", "p_00001a.hdf", "q_000012.hdf", "p_000012.hdf5",
                            "p_000012.h5", "my_p_000012.hdf"})
    EXPECT_FALSE(output::is_frame_name(other)) << other;
}

TEST(FrameSeries, IsParaViewsListOfFilesAndTimes) {
  output::FrameSeries series;
  EXPECT_EQ(nlohmann::json::parse(series.text())["files"].size(), 0U);
  series.add({"frames/p_000000.hdf", 0, 5});
  series.add({"frames/p_000001.hdf", 1.0 / 3e5, 4});
  const auto list = nlohmann::json::parse(series.text());
  EXPECT_EQ(list["file-series-version"], "1.0");
  ASSERT_EQ(list["files"].size(), 2U);
  EXPECT_EQ(list["files"][1]["name"], "frames/p_000001.hdf");
  EXPECT_EQ(list["files"][1]["time"].get<double>(), 1.0 / 3e5) << "to the last digit";
}

// What readers make of it is tested with VTK's; this is what they are known to stumble over.
TEST(FrameXdmf, GivesEveryVertexItsPoint) {
  output::FrameXdmf xdmf;
  xdmf.add({"frames/p_000000.hdf", 0.5, 5});
  EXPECT_THAT(xdmf.text(), HasSubstr("CollectionType=\"Temporal\""));
  EXPECT_THAT(xdmf.text(), HasSubstr("<Time Value=\"0.5\"/>"));
  EXPECT_THAT(xdmf.text(),
              HasSubstr("<Topology TopologyType=\"Polyvertex\" NumberOfElements=\"5\" NodesPerElement=\"1\">"
                        "<DataItem Dimensions=\"5 1\" NumberType=\"Int\" Precision=\"8\" Format=\"HDF\">"
                        "frames/p_000000.hdf:/VTKHDF/Connectivity</DataItem></Topology>"));
}

TEST(FrameXdmf, LeavesOutAFrameWithoutPoints) {
  output::FrameXdmf xdmf;
  xdmf.add({"frames/p_000000.hdf", 0, 5});
  const std::string before = xdmf.text();
  xdmf.add({"frames/p_000001.hdf", 1, 0});
  EXPECT_EQ(xdmf.text(), before);
}

}  // namespace frame_series_test
