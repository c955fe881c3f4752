#include "apps/twin/twin_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/text/quantity.hpp"
#include "tests/apps/small_twins.hpp"

namespace app {
namespace twin_json_test {

TEST(TwinJson, HoldsFiguresCurvesAndMisfits) {
  const TwinTask task = test::small_task();
  const auto twins = test::small_twins(task);
  const auto misfit = specimen::compare(task.descriptors, descriptors_of(twins));
  const auto json = nlohmann::json::parse(twins_json(task, twins, misfit).dump());
  EXPECT_EQ(json["kind"], "twins");
  EXPECT_EQ(json["original"]["name"], "cut");
  EXPECT_EQ(json["original"]["aggregate_fraction"], task.descriptors.fraction);
  EXPECT_EQ(json["plan"]["count"], 2);
  EXPECT_EQ(json["plan"]["first_seed"], 5);
  EXPECT_EQ(json["plan"]["border"], "whole");
  ASSERT_EQ(json["twins"].size(), 2u);
  EXPECT_EQ(json["twins"][1]["file"], "twin_002.h5");
  EXPECT_EQ(json["twins"][1]["s2"]["radial"].size(), json["twins"][1]["s2"]["distance_m"].size());
  EXPECT_EQ(json["misfit"]["s2_rms"]["original_from_twins"], misfit.s2_rms.original);
  EXPECT_EQ(json["misfit"]["s2_rms"]["within"], misfit.s2_rms.within());
  EXPECT_EQ(json["misfit"]["median_diameter_m"]["twins_largest"], misfit.median_diameter.largest);
}

TEST(TwinJson, OfASingleTwinHasNoVerdict) {
  TwinTask task = test::small_task();
  task.count = 1;
  const auto twins = test::small_twins(task);
  const auto json = twins_json(task, twins, specimen::compare(task.descriptors, descriptors_of(twins)));
  EXPECT_TRUE(json["misfit"]["s2_rms"]["within"].is_null());
  EXPECT_TRUE(json["misfit"]["s2_rms"]["twin_from_others_mean"].is_null());
}

TEST(TwinJson, HasATableWithALineForEachSpecimen) {
  const TwinTask task = test::small_task();
  const auto twins = test::small_twins(task);
  std::istringstream csv(twins_csv(task, twins));
  std::vector<std::string> lines;
  for (std::string line; std::getline(csv, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0].rfind("file,seed,aggregate_fraction,median_diameter_m,mean_aspect,", 0), 0u);
  EXPECT_EQ(lines[1].rfind("original.h5,,0.", 0), 0u);
  const std::string figures = format_number(twins[1].descriptors.fraction) + ',' +
                              format_number(twins[1].descriptors.median_diameter);
  EXPECT_EQ(lines[3].rfind("twin_002.h5,6," + figures, 0), 0u);
  for (const std::string& line : lines)
    EXPECT_EQ(std::count(line.begin(), line.end(), ','), std::count(lines[0].begin(), lines[0].end(), ','));
}

}  // namespace twin_json_test
}  // namespace app
