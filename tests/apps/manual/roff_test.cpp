#include "apps/manual/man_pages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roff_test {

using testing::EndsWith;
using testing::StartsWith;

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

}  // namespace roff_test
