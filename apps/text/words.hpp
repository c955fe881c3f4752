/// Words for people: lists, counts, names of phases, and "did you mean ...?"
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace app {

/// In small letters; only A to Z change.
[[nodiscard]] std::string lower(std::string_view text);

/// Least number of letters to insert, delete, replace or swap with their neighbour (Damerau-Levenshtein,
/// restricted).
[[nodiscard]] int edit_distance(std::string_view first, std::string_view second);

/// The candidate closest to what was written, upper and lower case alike; empty when none is close (one edit
/// for every three letters).
[[nodiscard]] std::string closest(std::string_view written, const std::vector<std::string>& candidates);

/// "did you mean X?", or empty when none is close.
[[nodiscard]] std::string did_you_mean(std::string_view written, const std::vector<std::string>& candidates);

/// "a, b or c".
template <class Range = std::vector<std::string>>
[[nodiscard]] std::string listed(const Range& items, const std::string& last = "or") {
  std::string text;
  std::size_t i = 0;
  for (const std::string& item : items) {
    if (i > 0) text += i + 1 == items.size() ? " " + last + " " : ", ";
    text += item;
    ++i;
  }
  return text;
}

/// The word of a value, from a table that has all values; empty for one that it has not.
template <class E>
[[nodiscard]] std::string word_in(std::initializer_list<std::pair<E, const char*>> table, E value) {
  for (const auto& [one, word] : table)
    if (one == value) return word;
  return {};
}

[[nodiscard]] std::string upper(std::string text);  ///< "length" -> "LENGTH"
/// "aggregate" for 1, "aggregates" for other counts; for nouns with a regular plural.
[[nodiscard]] std::string noun_for(std::int64_t count, std::string_view noun);

/// "1 aggregate", "151 aggregates", "2 classes".
[[nodiscard]] std::string counted(std::int64_t count, std::string_view noun);

}  // namespace app

namespace output {

[[nodiscard]] std::string capitalised(std::string text);         ///< "tension" -> "Tension"
[[nodiscard]] std::string phase_word(const std::string& phase);  ///< "itz" -> "ITZ", others as they are

}  // namespace output
