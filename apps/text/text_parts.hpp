/// Cutting up what people write.
/// Lines of tables whose cells stand between commas.
/// Commands that a message tells the user to give.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace app {

/// The text without the blanks and tabs at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The text as a whole number; nullopt unless it is one from its first letter to its last.
[[nodiscard]] std::optional<std::int64_t> whole_number(std::string_view text);

struct CsvCell {
  std::string text;  ///< without the blanks round it
  int column = 1;    ///< where it begins in its line
};

/// The cells of a line; a line without a comma has one.
[[nodiscard]] std::vector<CsvCell> csv_cells(const std::string& line);

/// An argument as a shell takes it, in quotes where it needs them.
[[nodiscard]] std::string shell_word(const std::string& text);

}  // namespace app
