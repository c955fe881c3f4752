#include "apps/twin/twin_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "specimen/file/specimen_file.hpp"
#include "tests/apps/small_twins.hpp"
#include "tests/specimen/temporary_folder.hpp"

namespace app {
namespace twin_folder_test {

using testing::HasSubstr;

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

}  // namespace twin_folder_test
}  // namespace app
