#include "apps/text/words.hpp"

#include "apps/text/complaint.hpp"

#include <algorithm>
#include <limits>

namespace app {

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return result;
}

int edit_distance(std::string_view first, std::string_view second) {
  std::vector<int> before(second.size() + 1);
  std::vector<int> row(second.size() + 1);
  std::vector<int> next(second.size() + 1);
  for (std::size_t j = 0; j <= second.size(); ++j) row[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= first.size(); ++i) {
    next[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= second.size(); ++j) {
      const int replaced = row[j - 1] + (first[i - 1] == second[j - 1] ? 0 : 1);
      next[j] = std::min({row[j] + 1, next[j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && first[i - 1] == second[j - 2] && first[i - 2] == second[j - 1];
      if (swapped) next[j] = std::min(next[j], before[j - 2] + 1);
    }
    before.swap(row);
    row.swap(next);
  }
  return row[second.size()];
}

std::string closest(std::string_view written, const std::vector<std::string>& candidates) {
  constexpr std::size_t longest = 200;  // what is longer resembles nothing, and takes long to compare
  if (written.size() > longest) return {};
  std::string best;
  int best_distance = std::numeric_limits<int>::max();
  for (const std::string& candidate : candidates) {
    const int distance = edit_distance(lower(written), lower(candidate));
    if (distance >= best_distance) continue;
    best = candidate;
    best_distance = distance;
  }
  const auto length = static_cast<int>(std::max(written.size(), best.size()));
  return best_distance <= std::max(1, length / 3) ? best : std::string();
}

std::string did_you_mean(std::string_view written, const std::vector<std::string>& candidates) {
  return text(Suggestion{closest(written, candidates), {}});
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string noun_for(std::int64_t count, std::string_view noun) {
  if (count == 1) return std::string(noun);
  return std::string(noun) + (noun.ends_with('s') ? "es" : "s");
}

std::string counted(std::int64_t count, std::string_view noun) {
  return std::to_string(count) + " " + noun_for(count, noun);
}

}  // namespace app

namespace output {

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string phase_word(const std::string& phase) { return phase == "itz" ? "ITZ" : phase; }

}  // namespace output
