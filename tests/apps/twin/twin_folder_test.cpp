#include "apps/twin/twin_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "apps/text/quantity.hpp"
#include "specimen/file/specimen_file.hpp"
#include "tests/apps/small_twins.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace app {
namespace twin_folder_test {

using testing::HasSubstr;
using testing::Not;

TEST(TwinFolder, ExplainsItself) {
  const test::TemporaryFolder folder;
  const TwinTask task = test::small_task();
  const TwinStatistics statistics =
      write_twin_statistics(folder / "", task, test::small_twins(task), {"a note of the conversion <&>"});
  EXPECT_EQ(statistics.notes.front(), "a note of the conversion <&>");
  EXPECT_GT(statistics.notes.size(), 3u);
  EXPECT_EQ(test::read_text(folder / "statistics.json"), statistics.json);
  EXPECT_EQ(nlohmann::json::parse(statistics.json)["notes"], statistics.notes);
  EXPECT_THAT(test::read_text(folder / "statistics.csv"), HasSubstr("original.h5,,"));
  EXPECT_EQ(specimen::read_specimen(folder / "original.h5").mask, task.original.mask);
  EXPECT_EQ(test::read_text(folder / "study.toml"),
            "title = \"Twins of cut\"\nscene = \"scene.toml\"  # loading, phases and solver of all of them\n"
            "# seeds = 4           # runs of each twin with other random strengths\n\n"
            "[vary]\n\"specimen.file\" = [\n  \"twin_001.h5\",\n  \"twin_002.h5\",\n]\n");
  EXPECT_THAT(test::read_text(folder / "scene.toml"), HasSubstr("file = \"twin_001.h5\""));
  const std::string page = test::read_text(folder / "report.html");
  EXPECT_THAT(page, HasSubstr("<h1>Twins of cut</h1>"));
  EXPECT_THAT(page, HasSubstr("A note of the conversion &lt;&amp;&gt;."));
  EXPECT_THAT(page, HasSubstr("S2, root mean square (%)"));
  EXPECT_THAT(page, HasSubstr("within"));
}

TEST(TwinFolder, WarnsOfAnOriginalThatIsNoConcrete) {
  const test::TemporaryFolder folder;
  TwinTask task = test::small_task();
  const auto twins = test::small_twins(task);
  EXPECT_TRUE(
      nlohmann::json::parse(write_twin_statistics(folder / "", task, twins, {}).json)["warnings"].empty());
  EXPECT_THAT(test::read_text(folder / "report.html"), Not(HasSubstr("Warnings")));
  task.original.mask.pixel_size = 1e-6;
  const TwinStatistics statistics = write_twin_statistics(folder / "", task, twins, {});
  EXPECT_THAT(nlohmann::json::parse(statistics.json)["warnings"].dump(), HasSubstr("0.08 mm wide"));
  EXPECT_THAT(test::read_text(folder / "report.html"), HasSubstr("the specimen is 0.08 mm wide"));
}

TEST(TwinFolder, LosesTwinsOfAnEarlierRunAndNothingElse) {
  const test::TemporaryFolder folder;
  for (const char* name : {"twin_002.h5", "twin_003.h5", "twin_003_preview.png", "twin_my.h5", "mine.txt"})
    test::write_text(folder / name, "");
  const TwinTask task = test::small_task();
  (void)write_twin_statistics(folder / "", task, test::small_twins(task), {});
  EXPECT_TRUE(std::filesystem::exists(folder / "twin_002.h5"));
  EXPECT_FALSE(std::filesystem::exists(folder / "twin_003.h5"));
  EXPECT_FALSE(std::filesystem::exists(folder / "twin_003_preview.png"));
  EXPECT_TRUE(std::filesystem::exists(folder / "twin_my.h5"));
  EXPECT_TRUE(std::filesystem::exists(folder / "mine.txt"));
}

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

}  // namespace twin_folder_test
}  // namespace app
