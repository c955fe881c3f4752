#include "apps/text/complaint.hpp"

#include <gtest/gtest.h>

namespace complaint_test {

TEST(Complaint, NamesPlaceFieldValueAllowedAndCure) {
  app::Complaint one = app::complaint("loading.velocity", "0.05", "needs a unit", "write it");
  one.place = {"scene.toml", 3, 12};
  EXPECT_EQ(text(one), "scene.toml:3:12: loading.velocity: 0.05; needs a unit; write it");
}

TEST(Complaint, LeavesEmptyPartsOut) {
  EXPECT_EQ(text(app::complaint("INPUT", "missing", "", "mesopix simulate INPUT")),
            "INPUT: missing; mesopix simulate INPUT");
  app::Complaint of_file = app::complaint("", "empty", "");
  of_file.place.file = "scene.toml";
  EXPECT_EQ(text(of_file), "scene.toml: empty");
}

TEST(Complaint, StaysOnOneLineWhateverTheUserWrote) {
  EXPECT_EQ(text(app::complaint("--title", "two\nlines\x1b[31m", "", "")), "--title: two?lines?[31m");
}

TEST(Complaint, IsCutWhereNobodyReadsOn) {
  EXPECT_EQ(text(app::complaint(std::string(5000, 'a'), "1", "")), std::string(2000, 'a') + "...: 1");
}

TEST(Printable, LeavesNothingThatATerminalObeys) {
  EXPECT_EQ(app::printable("caf\xC3\xA9 \xF0\x9F\x98\x80 10 \xC2\xB5m"),
            "caf\xC3\xA9 \xF0\x9F\x98\x80 10 \xC2\xB5m");
  EXPECT_EQ(app::printable("a\x7F"
                           "b\xC2\x9B"
                           "31mc\xE2\x80\xAE"
                           "d\xE2\x81\xA6"
                           "e"),
            "a?b?31mc?d?e");
  EXPECT_EQ(app::printable("caf\xE9 \xC2"), "caf? ?") << "bytes that are no UTF-8";
  EXPECT_EQ(app::printable("one\ntwo\r"), "one?two?");
  EXPECT_EQ(app::printable_lines("one\ntwo\r"), "one\ntwo?");
}

TEST(Quoted, EscapesAsTomlDoes) {
  EXPECT_EQ(app::quoted("a \"b\" \\ c\n\t\x01"), "\"a \\\"b\\\" \\\\ c\\n\\t\\u0001\"");
  EXPECT_EQ(app::quoted("\xC2\x9B"
                        "31m \xE2\x80\xAE caf\xC3\xA9"),
            "\"\\u009B31m \\u202E caf\xC3\xA9\"");
}

TEST(IsUtf8, TellsTextFromOtherBytes) {
  for (const char* text : {"", "plain", "caf\xC3\xA9", "\xE2\x82\xAC", "\xF0\x9F\x98\x80"})
    EXPECT_TRUE(app::is_utf8(text)) << text;
  // Latin-1; a lone continuation; cut short; overlong; a surrogate; beyond the last code point.
  for (const char* bytes :
       {"caf\xE9", "\x80", "\xE2\x82", "\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80"})
    EXPECT_FALSE(app::is_utf8(bytes)) << bytes;
}

TEST(Rejected, TellsEveryComplaint) {
  const app::Rejected rejected(app::Exit::data,
                               {app::complaint("a", "1", "", ""), app::complaint("b", "2", "", "")});
  EXPECT_STREQ(rejected.what(), "a: 1\nb: 2");
}

}  // namespace complaint_test
