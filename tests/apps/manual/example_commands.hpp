/// The commands in the examples of a help.
#pragma once

#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "apps/manual/command_tree.hpp"

namespace test {

/// Each line that begins with "  mesopix ", without the blanks.
inline std::vector<std::string> example_commands(const std::string& footer) {
  std::vector<std::string> commands;
  for (const std::string& line : manual::lines_of(footer))
    if (line.rfind("  mesopix ", 0) == 0) commands.push_back(line.substr(2));
  return commands;
}

/// A command line cut into words as a shell does, up to a pipe, a > or a comment.
/// @pre no other means of the shell than double quotes round whole words.
inline std::vector<std::string> shell_words(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  const auto ends = [](const std::string& word) { return word == "|" || word == ">" || word == "#"; };
  for (std::string word; stream >> std::quoted(word) && !ends(word);) words.push_back(word);
  return words;
}

}  // namespace test
