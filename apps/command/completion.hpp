/// What may follow on a command line, for the completions of shells.
#pragma once

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): a library's own
class App;
}

namespace app {

/// @param words  behind the name of the program; the last one is that at the cursor, as far as it is typed.
/// @return lines that the scripts in apps/command/completions/ read: a word, often with its help behind a
/// tab;
/// "@files" with the endings of the files that fit, without endings for any file; "@folders". What ends in =
/// has its value behind it. Of a word with a = the lines complete what stands behind that.
[[nodiscard]] std::string completions(const CLI::App& program, const std::vector<std::string>& words);

}  // namespace app
