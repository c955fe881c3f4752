/// The examples in the help of every command: the parser of the program takes them, and their values are what
/// the options are for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <CLI/CLI.hpp>
#include <regex>

#include "apps/command/command_line.hpp"
#include "apps/manual/command_tree.hpp"
#include "tests/apps/manual/example_commands.hpp"
#include "tests/apps/manual/program_tree.hpp"

namespace command_tree_examples_test {

using manual::Command;

/// Of a setting with this key, by the field itself.
void read(const app::Field& field, const std::string& text) {
  app::Settings settings;
  field.set(settings, app::from_command_line(field.form.kind, text));
}

std::optional<app::Field> setting_of(const CLI::Option& option) {
  for (const app::Field& field : app::fields())
    for (const std::string& name : option.get_lnames())
      if (name == app::with_dashes(field.key)) return field;
  return std::nullopt;
}

/// Of an option that is no setting.   @throws app::Mistake.
void read(const app::Form& form, const std::string& text) {
  if (std::find(form.words.begin(), form.words.end(), text) != form.words.end()) return;
  if (form.measure)
    (void)app::parse_quantity(text, form.measure->dimension);
  else if (form.whole)
    (void)app::WholeNumberCodec().read(app::from_command_line(app::Kind::integer, text));
  else if (form.name == "I:J" && !std::regex_match(text, std::regex("[0-9]+:[0-9]+")))
    throw app::Mistake("must be I:J");
  else if (form.kind == app::Kind::choice)
    throw app::Mistake("must be " + type(form));
}

void read_results(const CLI::App& command, const CLI::Option& option) {
  if (option.get_positional() || option.get_items_expected_max() == 0) return;
  const std::optional<app::Field> setting = setting_of(option);
  for (const std::string& text : option.results())
    setting ? read(*setting, text) : read(app::form_of(command, option), text);
}

const CLI::App& deepest(const CLI::App& command) {
  const std::vector<CLI::App*> below = command.get_subcommands();
  return below.empty() ? command : deepest(*below.front());
}

void look_at(const CLI::App& command) {
  app::refuse_remaining(command);
  for (const CLI::Option* option : command.get_options()) {
    read_results(command, *option);
    const bool may_be_left_out = option->get_name(true, false).front() == '[';
    if (option->get_positional() && !may_be_left_out && option->count() == 0)
      throw app::Mistake(option->get_name(true, false) + " is missing");
  }
}

/// What the program would say to a command line; empty = nothing.
std::string complaint_about(const std::string& line) {
  std::vector<std::string> words = test::shell_words(line);
  words.erase(words.begin());
  try {
    for (std::size_t i = 0; i + 1 < words.size(); ++i)
      if (words[i].rfind("--", 0) == 0)
        if (const std::string key = app::phase_key(words[i].substr(2)); !key.empty())
          read(*app::find_field(key), words[i + 1]);
    app::look_at_parsed(
        words, [](const CLI::App& command) { look_at(deepest(command)); }, app::evidence_commands());
  } catch (const app::Mistake& mistake) {
    return mistake.allowed;
  } catch (const std::exception& error) {
    return error.what();
  }
  return {};
}

TEST(Examples, EveryHelpEndsWithOne) {
  for (const Command* command : every_command(test::program_tree())) {
    if (command->words.size() == 1) continue;
    const manual::HelpText text = manual::help_text(command->footer);
    ASSERT_FALSE(text.examples.empty()) << joined(*command, " ");
    ASSERT_FALSE(text.examples.back().verbatim.empty()) << joined(*command, " ");
    EXPECT_EQ(text.examples.back().verbatim.back().rfind("mesopix ", 0), 0u) << joined(*command, " ");
    EXPECT_NE(command->footer.find("  " + joined(*command, " ")), std::string::npos) << joined(*command, " ");
  }
}

TEST(Examples, TheParserTakesEveryOne) {
  std::size_t count = 0;
  for (const Command* command : every_command(test::program_tree()))
    for (const std::string& line : test::example_commands(command->footer)) {
      EXPECT_EQ(complaint_about(line), "") << joined(*command, " ") << ": " << line;
      ++count;
    }
  EXPECT_GT(count, 20u);
}

TEST(Examples, WrongOnesWouldBeSeen) {
  using testing::HasSubstr;
  EXPECT_THAT(complaint_about("mesopix simulate a.h5 --velocty \"1 m/s\""),
              HasSubstr("did you mean --velocity?"));
  EXPECT_THAT(complaint_about("mesopix simulate a.h5 --velocity 1"), HasSubstr("needs a unit"));
  EXPECT_THAT(complaint_about("mesopix simulate a.h5 --mortar.young 3"), HasSubstr("needs a unit"));
  EXPECT_THAT(complaint_about("mesopix simulate a.h5 --platen rogh"), HasSubstr("must be smooth or rough"));
  EXPECT_THAT(complaint_about("mesopix plot a --what dammage"), HasSubstr("must be damage|stress|curve"));
  EXPECT_THAT(complaint_about("mesopix study submit a.toml --chunk many"),
              HasSubstr("must be a whole number"));
  EXPECT_THAT(complaint_about("mesopix study sumbit a.toml"), HasSubstr("one argument too many"));
  EXPECT_THAT(complaint_about("mesopix plot"), HasSubstr("RUN is missing"));
  EXPECT_THAT(complaint_about("mesopix plott a"), HasSubstr("did you mean plot?"));
}

}  // namespace command_tree_examples_test
