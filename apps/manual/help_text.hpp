/// What the help of a command says at its end, taken apart: running text, lists and examples.
#pragma once

#include <string>
#include <vector>

namespace manual {

/// A line of two columns.
struct Item {
  std::string term;
  std::string text;
};

/// One of the three: text that flows, lines that stay as they are, or a list.
struct Passage {
  std::string text;
  std::vector<std::string> verbatim;  ///< without the two blanks before each
  std::vector<Item> items;
};

struct HelpText {
  std::vector<Passage> notes;
  std::vector<Passage> examples;  ///< from the line that begins with "Example" on
};

/// Lines that begin with two blanks stay as they are; lines with more blanks inside are items of a list, and
/// what is indented farther goes on with one; all others flow.
[[nodiscard]] HelpText help_text(const std::string& footer);

/// Each line that begins with "  mesopix ", without the blanks.
[[nodiscard]] std::vector<std::string> example_commands(const std::string& footer);

/// A command line cut into words as a shell does, up to a pipe, a > or a comment.
/// @pre no other means of the shell than double quotes round whole words.
[[nodiscard]] std::vector<std::string> shell_words(const std::string& line);

}  // namespace manual
