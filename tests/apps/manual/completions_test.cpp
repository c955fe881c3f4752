#include "apps/manual/completions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/manual/program_tree.hpp"

namespace completions_test {

using testing::AllOf;
using testing::HasSubstr;

TEST(Completions, ThereIsOneForEachShell) {
  std::vector<std::string> names;
  for (const manual::File& file : completions(test::program_tree())) names.push_back(file.name);
  EXPECT_THAT(names, testing::ElementsAre("mesopix.bash", "_mesopix", "mesopix.fish"));
}

TEST(Completions, QuotesOfAHelpStayPartOfIt) {
  manual::Command program;
  program.words = {"mesopix"};
  program.options = {{{"--young"}, "PRESSURE", "Young's [modulus]: \\ of $it", "Options"}};
  EXPECT_THAT(fish_completion(program), HasSubstr(" -l young -x -d 'Young\\'s [modulus]: \\\\ of $it'\n"));
  EXPECT_THAT(zsh_completion(program),
              HasSubstr("'(--young)--young=[Young'\\''s \\[modulus\\]\\: \\\\ of $it]:PRESSURE: '"));
}

TEST(Completions, OfZshHidesTheNamesByKey) {
  EXPECT_THAT(zsh_completion(test::program_tree()),
              AllOf(HasSubstr("'(--platen --loading.platen)--platen=["),
                    HasSubstr("'!(--platen --loading.platen)--loading.platen=[")));
}

}  // namespace completions_test
