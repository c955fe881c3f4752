#include "apps/manual/reference.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/apps/manual/program_tree.hpp"

namespace reference_test {

using testing::AllOf;
using testing::HasSubstr;

/// Cells of a table of Markdown end at bars; a row with too many or too few is no row.
void expect_even_tables(const std::string& page) {
  std::istringstream lines(page);
  std::ptrdiff_t bars = 0;
  for (std::string line; std::getline(lines, line);) {
    const bool row = line.rfind("|", 0) == 0;
    const std::ptrdiff_t here = std::count(line.begin(), line.end(), '|');
    EXPECT_TRUE(!row || bars == 0 || here == bars) << line;
    bars = row ? here : 0;
  }
}

TEST(Reference, HasAPageOfCommandsScenesAndExitCodes) {
  std::vector<std::string> names;
  for (const manual::File& file : reference(test::program_tree(), "title = 1\n")) {
    names.push_back(file.name);
    EXPECT_EQ(file.text.rfind("# ", 0), 0u) << file.name;
    EXPECT_EQ(file.text.back(), '\n');
    expect_even_tables(file.text);
  }
  EXPECT_THAT(names, testing::ElementsAre("commands.md", "scene.md", "exit_codes.md"));
}

TEST(Reference, OfCommandsHoldsOptionsAndExamples) {
  const std::string page = commands_page(test::program_tree());
  EXPECT_THAT(page,
              AllOf(HasSubstr("- [mesopix simulate](#mesopix-simulate): Break a specimen"),
                    HasSubstr("    - [mesopix study submit](#mesopix-study-submit): "),
                    HasSubstr("\n## mesopix simulate\n"), HasSubstr("\n### mesopix study submit\n"),
                    HasSubstr("| <code>--platen smooth&#124;rough</code>, `--loading.platen` |"),
                    HasSubstr("| `-o`, `--output DIR` |"), HasSubstr("```sh\nmesopix simulate specimen.h5 "),
                    HasSubstr("[scene files](scene.md)"), HasSubstr("`NO_COLOR`")));
}

TEST(Reference, OfScenesHoldsKeysWithTypeDefaultAndWhatIsAllowed) {
  const std::string page = manual::scene_page("[loading]\n");
  EXPECT_THAT(page, HasSubstr("| `velocity` | `VELOCITY` | `\"0.05 m/s\"` | > 0 | of the top platen |\n"));
  EXPECT_THAT(page, HasSubstr("```toml\n[loading]\n```\n"));
  EXPECT_THAT(page, HasSubstr("\n## `[[ellipses]]`\n"));
}

TEST(Reference, OfExitCodesHoldsThemAll) {
  EXPECT_THAT(manual::exit_codes_page(),
              AllOf(HasSubstr("| 0 | `EX_OK` |"), HasSubstr("| 75 | `EX_TEMPFAIL` |")));
}

}  // namespace reference_test
