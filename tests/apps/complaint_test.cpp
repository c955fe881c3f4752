#include "apps/complaint.hpp"

#include <gtest/gtest.h>

namespace {

TEST(Complaint, NamesPlaceFieldValueAllowedAndCure) {
  const app::Complaint one{{"scene.toml", 3, 12}, "loading.velocity", "0.05", "needs a unit", "write it"};
  EXPECT_EQ(text(one), "scene.toml:3:12: loading.velocity: 0.05; needs a unit; write it");
}

TEST(Complaint, LeavesEmptyPartsOut) {
  EXPECT_EQ(text(app::complaint("INPUT", "missing", "", "mesopix simulate INPUT")),
            "INPUT: missing; mesopix simulate INPUT");
  EXPECT_EQ(text(app::Complaint{{"scene.toml", 0, 0}, "", "empty", "", ""}), "scene.toml: empty");
}

TEST(Complaint, StaysOnOneLineWhateverTheUserWrote) {
  EXPECT_EQ(text(app::complaint("--title", "two\nlines\x1b[31m", "", "")), "--title: two?lines?[31m");
}

TEST(Quoted, EscapesAsTomlDoes) {
  EXPECT_EQ(app::quoted("a \"b\" \\ c\n\t\x01"), "\"a \\\"b\\\" \\\\ c\\n\\t\\u0001\"");
}

TEST(Rejected, TellsEveryComplaint) {
  const app::Rejected rejected(app::Exit::data,
                               {app::complaint("a", "1", "", ""), app::complaint("b", "2", "", "")});
  EXPECT_STREQ(rejected.what(), "a: 1\nb: 2");
}

}  // namespace
