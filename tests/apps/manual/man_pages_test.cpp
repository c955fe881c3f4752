#include "apps/manual/man_pages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/apps/manual/program_tree.hpp"

namespace man_pages_test {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::string page_of(const std::string& command) {
  return command_man_page(test::command_named(command), test::program_tree());
}

TEST(ManPages, ThereIsOneForEveryCommandAndForScenes) {
  std::vector<std::string> names;
  for (const manual::File& file : man_pages(test::program_tree(), "")) names.push_back(file.name);
  EXPECT_THAT(names, testing::IsSupersetOf({"mesopix.1", "mesopix-simulate.1", "mesopix-study-submit.1",
                                            "mesopix-help.1", "mesopix-scene.5"}));
  EXPECT_EQ(names.size(), every_command(test::program_tree()).size() + 1);
}

TEST(ManPages, HoldArgumentsOptionsAndExamples) {
  const std::string page = page_of("simulate");
  EXPECT_THAT(page,
              AllOf(HasSubstr(".SH SYNOPSIS\n\\fBmesopix simulate\\fR [OPTION...] [INPUT]\n"),
                    HasSubstr(".SH ARGUMENTS\n.TP\n\\fIINPUT\\fR\n"),
                    HasSubstr(".TP\n\\fB\\-o\\fR, \\fB\\-\\-output\\fR \\fIDIR\\fR\nfolder "),
                    HasSubstr(".SS Loading\n"), HasSubstr("\\fB\\-\\-platen\\fR \\fIsmooth|rough\\fR\n"),
                    HasSubstr(".SH EXAMPLES\n"), HasSubstr("mesopix simulate \\-\\-resume run\n"),
                    HasSubstr(".SH EXIT STATUS\n")));
  EXPECT_THAT(page, Not(HasSubstr("generate.width")));
  EXPECT_THAT(page, HasSubstr("\\fBmesopix\\-scene\\fR(5)"));
}

TEST(ManPages, TheProgramListsItsCommandsInTheOrderOfWork) {
  const std::string page = command_man_page(test::program_tree(), test::program_tree());
  const std::size_t first = page.find("\\fBmesopix\\-generate\\fR(1)");
  ASSERT_NE(first, std::string::npos);
  EXPECT_LT(first, page.find("\\fBmesopix\\-simulate\\fR(1)"));
  EXPECT_THAT(page, AllOf(HasSubstr(".SH ENVIRONMENT\n"), HasSubstr("NO_COLOR")));
  EXPECT_THAT(page, HasSubstr("mesopix \\- from a picture of concrete to a broken specimen\n"));
}

TEST(ManPages, OfACommandBelowAnotherNamesItInFull) {
  EXPECT_THAT(page_of("study submit"), HasSubstr("\\fBmesopix study submit\\fR [OPTION...] STUDY\n"));
  EXPECT_THAT(page_of("study"), HasSubstr("\\fBmesopix\\-study\\-submit\\fR(1)"));
}

TEST(ManPages, OfScenesHoldsEveryKeyWithWhatItMayBe) {
  const std::string page = manual::scene_man_page("# a scene\n[loading]\n");
  EXPECT_THAT(page, HasSubstr(".SS [loading]: Loading\n"));
  EXPECT_THAT(
      page,
      HasSubstr(
          "\\fBvelocity\\fR \\fIVELOCITY\\fR\nof the top platen. Allowed: > 0. Default: \"0.05 m/s\".\n"));
  EXPECT_THAT(page, HasSubstr(".SS [phases.NAME]: Phases\n"));
  EXPECT_THAT(page, HasSubstr("# a scene\n[loading]\n.fi\n"));
}

TEST(Roff, TakesNoLetterForARequest) {
  EXPECT_EQ(manual::roff("--a-b"), "\\-\\-a\\-b");
  EXPECT_EQ(manual::roff(".toml's"), "\\&.toml\\(aqs");
  EXPECT_EQ(manual::roff("'a"), "\\(aqa");
  EXPECT_EQ(manual::roff("a\\b ^ ~ `"), "a\\eb \\(ha \\(ti \\(ga");
  EXPECT_EQ(manual::bold("-o"), "\\fB\\-o\\fR");
  EXPECT_EQ(manual::italic("DIR"), "\\fIDIR\\fR");
}

TEST(Roff, APageBeginsWithItsTitleAndItsName) {
  const manual::ManPage page("mesopix-study-submit", 1, "leave it");
  EXPECT_THAT(page.text(), StartsWith(".TH MESOPIX\\-STUDY\\-SUBMIT 1 \"\" \"mesopix "));
  EXPECT_THAT(page.text(), EndsWith("\n.SH NAME\nmesopix\\-study\\-submit \\- leave it\n"));
}

TEST(Roff, LongTextIsBrokenBetweenItsWords) {
  manual::ManPage page("a", 5, "b");
  page.section("S");
  page.paragraph(std::string(77, 'x') + " .toml y");
  EXPECT_THAT(page.text(), EndsWith(std::string(77, 'x') + "\n\\&.toml y\n"));
}

TEST(Roff, ParagraphsAreSetApartButFromTheirHeading) {
  manual::ManPage page("a", 5, "b");
  page.section("FIRST");
  page.paragraph("one");
  page.paragraph("two");
  page.subsection("Second");
  page.item("term", "text");
  page.verbatim({"x", "", ".y"});
  EXPECT_THAT(page.text(), EndsWith(".SH FIRST\none\n.PP\ntwo\n.SS Second\n.TP\nterm\ntext\n"
                                    ".PP\n.RS 4\n.nf\nx\n\\&\n\\&.y\n.fi\n.RE\n"));
}

}  // namespace man_pages_test
