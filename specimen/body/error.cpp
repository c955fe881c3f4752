#include "specimen/body/error.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace specimen {
namespace {

std::string sentence(const std::string& field, const std::string& value, const std::string& allowed,
                     const std::string& cure) {
  std::string text = field + ": " + value;
  if (!allowed.empty()) text += "; " + allowed;
  if (!cure.empty()) text += "; " + cure;
  return text;
}

}  // namespace

Error::Error(std::string field_name, std::string value_met, std::string what_is_allowed,
             std::string how_to_cure, Fault kind)
    : std::runtime_error(sentence(field_name, value_met, what_is_allowed, how_to_cure)),
      field(std::move(field_name)),
      value(std::move(value_met)),
      allowed(std::move(what_is_allowed)),
      cure(std::move(how_to_cure)),
      fault(kind) {}

namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// Letters to insert, to drop or to replace to get from one word to the other (Levenshtein).
std::size_t edits(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row;
  for (std::size_t j = 0; j <= to.size(); ++j) row.push_back(j);
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = std::exchange(row.front(), i + 1);
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = diagonal + (lower(from[i]) == lower(to[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string number(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  std::array<char, 32> text;
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6);
  return {text.data(), end.ptr};
}

std::string millimetres(double metres) { return number(metres * 1e3) + " mm"; }

std::string percent(double share) { return number(share * 100) + " %"; }

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string nearest_name(std::string_view misspelt, const std::vector<std::string>& names) {
  std::string best;
  std::size_t fewest = misspelt.size() / 3 + 2;  // a word that shares hardly a letter is no help
  for (const std::string& name : names) {
    const std::size_t count = edits(misspelt, name);
    if (count < fewest && count < name.size()) {
      fewest = count;
      best = name;
    }
  }
  return best;
}

}  // namespace specimen
